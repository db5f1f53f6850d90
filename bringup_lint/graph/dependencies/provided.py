"""Packages that anything of a tree brings: a script, an image, a list of repositories, the documentation."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise

from bringup_lint.discover.tree import Tree
from bringup_lint.facts.ros import distros
from bringup_lint.facts.ros.needed import Needed
from bringup_lint.graph.containers.base_images import is_plain
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.pattern import regex

_TELLING = regex(
    r"(?:^|/)(?:[^/]*dockerfile[^/]*|\.gitmodules|[Mm]akefile|[Jj]ustfile|setup\.py"
    r"|[^/]+\.(?:sh|bash|zsh|md|rst|txt|repos|rosinstall|ya?ml|j2|toml|nix|bb|bbappend|cfg|json|ipynb|html?))$",
    re.I,
)
_PAGE = regex(r"\.(?:md|rst|txt|html?)$", re.I)
_DOCUMENTATION = regex(r"\.(?:md|rst|html?|ipynb)$|(?:^|/)(?:readme|changelog|license|todo)[^/]*$", re.I)
_HISTORY = regex(r"(?:^|/)changelog[^/]*$", re.I)
_NO_INSTALLER = regex(r"(?:^|/)(?:setup\.py|setup\.cfg|(?!devcontainer\.)[^/]+\.json)$")
"""What lists no packages of ROS."""
_INSTALLS = regex(
    r"(?:\b(?:apt|apt-get|aptitude|pip3?|rosdep|conda|vcs|brew|yay|dnf|snap)\b|\bgit (?:clone|submodule)\b)"
    r"(?:\\\r?\n|[^\n`]){0,4000}"
)
"""A command of the documentation that installs, with the lines that it goes on in."""
_COMMENTS = regex(r"^[ \t]*#[^\n]*$", re.M)
_MOST = 200_000
"""Characters of a file that are looked at."""
_WORD = regex(r"[a-z][a-z0-9_-]{1,100}")
_PREFIX = regex(r"^ros_[a-z]{1,20}_")
_PACKAGED = regex(r"ros-(?:[a-z]+|\$[\w({}:)-]{1,40}|\{\{[^{}\n]{1,40}\}\}|<[^<>\n]{1,40}>)-([a-z0-9-]{2,60})")
_PATTERN = regex(
    r"\bros-(?:[a-z]+|\$[\w({}:)-]{1,40}|\{\{[^{}\n]{1,40}\}\}|<[^<>\n]{1,40}>)-([a-z0-9${}()_-]{0,60})\*", hints="ros-"
)
"""Debian packages of ROS by a pattern (``ros-humble-nav2-*``)."""
_SHORT = 3
"""Characters of a pattern that many packages begin with."""
_REPOSITORY = regex(r"(?:github|gitlab)\.com[/:][\w.-]{1,60}/([\w.-]{1,80})")
_ADDRESS = regex(r"(?:https?://|git@|ssh://git@)[\w.-]{1,80}[/:]([\w./-]{1,160})", hints="http:// https:// git@")
_OWNERS = frozenset(
    "ros-navigation ros-planning stevemacenski cra-ros-pkg ros-teleop ros-drivers ros-perception slamtec ros2".split()
)
"""Who has the public repositories themselves."""
_SHARED = (("nav2_", "navigation2"), ("dwb_", "navigation2"), ("opennav_", "navigation2"), ("joy", "joystick_drivers"))
"""How packages begin that come with others in one repository."""
ROSDEP = regex(r"\brosdep\s+install\b(?:\\\r?\n|[^\n`&;])*", hints="rosdep")
"""A command, with the lines that it goes on in."""
_PARAMETERS = "ros__parameters"
_VARIANT = regex(
    rf"(?:{'|'.join(distros.every())}|[}}>])[-_](desktop[-_]full|desktop|perception|simulation)(?![a-z])",
    hints="-desktop _desktop -perception _perception -simulation _simulation",
)
_VARIANTS = frozenset(("desktop", "desktop_full", "perception", "simulation"))


class Provided:
    def __init__(self, tree: Tree, dockerfiles: list[Dockerfile]) -> None:
        self._tree = tree
        self._dockerfiles = dockerfiles

    def brings(self, known: Needed) -> bool:
        """Whether anything of the tree may bring it, an image of others included."""
        if self._foreign_images or self._is_of_pattern(known) or known.words & self._variants:
            return True
        words = self._installed if known.is_package else self._words
        if (known.words - _VARIANTS) & words:
            return True
        if "_" not in known.name:
            return known.is_package and known.name in self._packaged
        parts = known.name.split("_")
        return any("_".join(parts[:end]) in words for end in range(max(2, len(parts) - 2), len(parts) + 1))

    def _is_of_pattern(self, known: Needed) -> bool:
        """Whether packages that are installed by a pattern may be it, or depend on it."""
        names = (known.name, *known.also)
        return any(
            len(begin) < _SHORT or known.comes_with(begin.rstrip("_")) or any(name.startswith(begin) for name in names)
            for begin in self._patterns
        )

    def has_repository(self, name: str) -> bool:
        """Whether a list of repositories or a command names a repository like a package."""
        return name.lower() in self._packaged

    def has_fork(self, package: str) -> bool:
        """Whether anything fetches the repository of a public package from others than those who release it."""
        name = next((repository for begin, repository in _SHARED if package.startswith(begin)), package)
        return name in self._forks

    @cached_property
    def _forks(self) -> frozenset[str]:
        """The names of repositories that do not come from their first owners."""
        paths = (path.split("/") for text in self._installing for path in _ADDRESS.findall(text))
        owned = ((owner, name) for parts in paths for owner, name in pairwise(parts) if owner not in _OWNERS)
        return frozenset(name.removesuffix(".git").replace("-", "_") for _, name in owned)

    @cached_property
    def mentions_rosdep(self) -> bool:
        """Whether any file names rosdep, whose options are not known then."""
        return any("rosdep" in text for text in self._texts)

    @cached_property
    def rosdep_commands(self) -> list[str]:
        """The commands of the documentation at the top of the tree that install with rosdep."""
        tops = [f"{top}/" for top in self._tree.tops]
        near = (path for path in self._tree.paths if _PAGE.search(path))
        shown = (path for path in near for top in tops if os.path.abspath(path).removeprefix(top).count("/") < 2)
        return [command for path in shown for command in ROSDEP.findall(self._tree.head(path, _MOST))]

    @cached_property
    def _texts(self) -> list[str]:
        return [text for _, text in self._by_path]

    @cached_property
    def _by_path(self) -> list[tuple[str, str]]:
        texts = ((path, self._tree.head(path, _MOST)) for path in self._tree.paths if _TELLING.search(path))
        return [(path, text.lower()) for path, text in texts if _PARAMETERS not in text]

    @cached_property
    def _read(self) -> list[tuple[str, str]]:
        """The texts by their paths, those of files that machines read without comments."""
        return [
            (path, text if _DOCUMENTATION.search(path) else _COMMENTS.sub("", text)) for path, text in self._by_path
        ]

    @cached_property
    def _installing(self) -> list[str]:
        """What installs: scripts, images and lists without their comments, and the commands of the documentation."""
        found: list[str] = []
        for path, text in self._read:
            if _DOCUMENTATION.search(path):
                found += _INSTALLS.findall(text)
            elif not _NO_INSTALLER.search(path):
                found.append(text)
        return found

    @cached_property
    def _installed(self) -> frozenset[str]:
        """The words of what installs."""
        return frozenset(word for text in self._installing for word in _words(text)) | self._packaged

    @cached_property
    def _words(self) -> frozenset[str]:
        """The words of all texts, with underscores, without the prefix of Debian packages."""
        return frozenset(word for text in self._texts for word in _words(text))

    @cached_property
    def _packaged(self) -> frozenset[str]:
        """What is named as a Debian package of ROS or as a repository."""
        texts = [text for path, text in self._read if not _HISTORY.search(path)]
        found = (match for text in texts for match in (*_PACKAGED.findall(text), *_REPOSITORY.findall(text)))
        return frozenset(name.removesuffix(".git").replace("-", "_") for name in found)

    @cached_property
    def _variants(self) -> frozenset[str]:
        """The variants of ROS that packages and images have in their names."""
        return frozenset(name.replace("-", "_") for text in self._texts for name in _VARIANT.findall(text))

    @cached_property
    def _patterns(self) -> frozenset[str]:
        """How the names of packages begin that are installed by a pattern: what they depend on is not known."""
        found = (begin for text in self._texts for begin in _PATTERN.findall(text))
        return frozenset(begin.replace("-", "_") if begin.isascii() and "$" not in begin else "" for begin in found)

    @cached_property
    def _foreign_images(self) -> bool:
        """Whether an image is built on one that others made, which may hold anything, and rosdep adds nothing to it."""
        files = (file for file in self._dockerfiles if not ROSDEP.search(file.source.text))
        origins = {stage.origin.lower() for file in files for stage in file.stages}
        return not all(map(is_plain, origins))


def _words(text: str) -> Iterator[str]:
    for match in _WORD.finditer(text):
        word = match[0].replace("-", "_")
        yield word
        yield _PREFIX.sub("", word)
