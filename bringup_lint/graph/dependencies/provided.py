"""Packages that anything of a tree brings: a script, an image, a list of repositories, the documentation."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.discover.tree import Tree
from bringup_lint.facts.ros import distros
from bringup_lint.facts.ros.needed import Needed
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.pattern import regex

_TELLING = regex(
    r"(?:^|/)(?:[^/]*dockerfile[^/]*|\.gitmodules|[Mm]akefile|[Jj]ustfile|setup\.py"
    r"|[^/]+\.(?:sh|bash|zsh|md|rst|txt|repos|rosinstall|ya?ml|j2|toml|nix|bb|bbappend|cfg|json|ipynb|html?))$",
    re.I,
)
_PAGE = regex(r"\.(?:md|rst|txt|html?)$", re.I)
_MOST = 200_000
"""Characters of a file that are looked at."""
_WORD = regex(r"[a-z][a-z0-9_-]{1,100}")
_PREFIX = regex(r"^ros_[a-z]{1,20}_")
_PACKAGED = regex(r"ros-(?:[a-z]+|\$[\w({}:)-]{1,40}|\{\{[^{}\n]{1,40}\}\}|<[^<>\n]{1,40}>)-([a-z0-9-]{2,60})")
_PATTERN = regex(r"\bros-[a-z0-9${}()_-]{1,60}\*")
"""Debian packages of ROS by a pattern (``ros-humble-nav2-*``)."""
_REPOSITORY = regex(r"(?:github|gitlab)\.com[/:][\w.-]{1,60}/([\w.-]{1,80})")
ROSDEP = regex(r"\brosdep\s+install\b(?:\\\r?\n|[^\n`&;])*")
"""A command, with the lines that it goes on in."""
_PARAMETERS = "ros__parameters"
_PLAIN = regex(
    r"^(?:docker\.io/|(?:library|arm64v8|arm32v7|amd64|osrf)/)*"
    r"(?:ros|ubuntu|debian|python|scratch|ros2|alpine|busybox|node|nginx)(?::|@|$)|^(?:nvidia/cuda|balenalib/\S*ubuntu\S*)\b"
)
"""Images that hold nothing of a robot but what their tag says."""
_VARIANT = regex(rf"(?:{'|'.join(distros.every())}|[}}>])[-_](desktop[-_]full|desktop|perception|simulation)(?![a-z])")
_VARIANTS = frozenset(("desktop", "desktop_full", "perception", "simulation"))


class Provided:
    def __init__(self, tree: Tree, dockerfiles: list[Dockerfile]) -> None:
        self._tree = tree
        self._dockerfiles = dockerfiles

    def brings(self, known: Needed) -> bool:
        """Whether anything of the tree may bring it, an image of others included."""
        words = known.words - _VARIANTS
        if self._foreign_images or self._many_packages or known.words & self._variants or words & self._words:
            return True
        if "_" not in known.name:
            return known.is_package and known.name in self._packaged
        parts = known.name.split("_")
        return any("_".join(parts[:end]) in self._words for end in range(max(2, len(parts) - 2), len(parts) + 1))

    def has_repository(self, name: str) -> bool:
        """Whether a list of repositories or a command names a repository like a package."""
        return name.lower() in self._packaged

    @cached_property
    def rosdep_commands(self) -> list[str]:
        """The commands of the documentation at the top of the tree that install with rosdep."""
        tops = [f"{top}/" for top in self._tree.tops]
        near = (path for path in self._tree.paths if _PAGE.search(path))
        shown = (path for path in near for top in tops if os.path.abspath(path).removeprefix(top).count("/") < 2)
        return [command for path in shown for command in ROSDEP.findall(self._tree.head(path, _MOST))]

    @cached_property
    def _texts(self) -> list[str]:
        texts = (self._tree.head(path, _MOST) for path in self._tree.paths if _TELLING.search(path))
        return [text.lower() for text in texts if _PARAMETERS not in text]

    @cached_property
    def _words(self) -> frozenset[str]:
        """The words of all texts, with underscores, without the prefix of Debian packages."""
        return frozenset(word for text in self._texts for word in _words(text))

    @cached_property
    def _packaged(self) -> frozenset[str]:
        """What is named as a Debian package of ROS or as a repository."""
        found = (match for text in self._texts for match in (*_PACKAGED.findall(text), *_REPOSITORY.findall(text)))
        return frozenset(name.removesuffix(".git").replace("-", "_") for name in found)

    @cached_property
    def _variants(self) -> frozenset[str]:
        """The variants of ROS that packages and images have in their names."""
        return frozenset(name.replace("-", "_") for text in self._texts for name in _VARIANT.findall(text))

    @cached_property
    def _many_packages(self) -> bool:
        """Whether packages are installed by a pattern: what they depend on is not known."""
        return any(_PATTERN.search(text) for text in self._texts)

    @cached_property
    def _foreign_images(self) -> bool:
        """Whether an image is built on one that others made, which may hold anything, and rosdep adds nothing to it."""
        files = (file for file in self._dockerfiles if not ROSDEP.search(file.source.text))
        origins = {stage.origin.lower() for file in files for stage in file.stages}
        return not all(map(_PLAIN.search, origins))


def _words(text: str) -> Iterator[str]:
    for match in _WORD.finditer(text):
        word = match[0].replace("-", "_")
        yield word
        yield _PREFIX.sub("", word)
