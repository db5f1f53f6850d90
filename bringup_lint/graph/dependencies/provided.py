"""Packages that anything of a tree brings, by what it installs and by the images that it is built on."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from itertools import pairwise

from bringup_lint.facts.ros import distros
from bringup_lint.facts.ros.needed import Needed
from bringup_lint.graph.containers.base_images import is_plain
from bringup_lint.graph.dependencies.installers import ADDRESS
from bringup_lint.graph.dependencies.installers import ROSDEP
from bringup_lint.graph.dependencies.installers import Installers
from bringup_lint.model.dockerfile import Dockerfile
from bringup_lint.pattern import regex

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
_INSTALLERS = regex(r"(?:^|_)(?:install(?:er|ers)?|setup|provisioning)(?:_|$)")
"""Of the name of a repository that people fetch to install a robot."""
_OWNERS = frozenset(
    "ros-navigation ros-planning stevemacenski cra-ros-pkg ros-teleop ros-drivers ros-perception slamtec ros2 "
    "ros-controls intelrealsense realsenseai".split()
)
"""Who has the public repositories themselves."""
_SHARED = (
    *(("nav2_", "navigation2"), ("dwb_", "navigation2"), ("opennav_", "navigation2"), ("joy", "joystick_drivers")),
    ("realsense2_", "realsense_ros"),
)
"""How packages begin that come with others in one repository."""
_CONTROLLERS = ("_controller", "_controllers", "_broadcaster")
"""How packages end that come with ros2_controllers."""
_RELEASE = regex(r"(?<![\d.])(\d{1,3})\.(\d{1,3})(?:\.(\d{1,3}))?(?![\d.])")
_REFERENCE = regex(
    r"(?:\bversion:\s{0,4}|(?<![\w-])-b\s{1,4}|--branch[\s=]{1,4}|\bcheckout\s{1,4}|(?:camera|ros)=)[\"']?([^\s\"']{1,80})"
)
"""How a branch, a release or a commit is named."""
_NEWEST = frozenset(("master", "main", "rolling", "ros2", "ros2-master", "ros2-development"))
_BESIDE = 120
"""Characters before and after a repository in which the release is named that is fetched."""
_PATCHED = regex(r"\bpatch(?:es)?/([\w-]{1,80})/|/([\w-]{1,80})\s{1,8}apply\b")
"""Repositories that are changed after they are fetched."""
_HAS_ROS = regex(rf"\bcolcon\b|/opt/ros\b|\bros[-:_\d]|\b(?:{'|'.join(distros.every())})\b")
_VARIANT = regex(
    rf"(?:{'|'.join(distros.every())}|[}}>])[-_](desktop[-_]full|desktop|perception|simulation)(?![a-z])",
    hints="-desktop _desktop -perception _perception -simulation _simulation",
)
_VARIANTS = frozenset(("desktop", "desktop_full", "perception", "simulation"))


class Provided:
    """Whether installers and images bring a package that the manifests do not."""

    def __init__(self, installers: Installers, dockerfiles: list[Dockerfile]) -> None:
        self._installers = installers
        self._dockerfiles = dockerfiles

    def brings(self, known: Needed) -> bool:
        """Whether anything of the tree may bring it, an image of others and a repository of installers included."""
        if self._fetches_installers or self._foreign_images:
            return True
        if self._is_of_pattern(known) or known.words & self._variants:
            return True
        return self.installs(known)

    def installs(self, known: Needed) -> bool:
        """Whether something of the tree names it where it installs."""
        if not known.is_package and self._installers.lists_elsewhere:
            return True
        if (known.words - _VARIANTS) & self._installed or any(map(self._has_beginning, known.beginnings)):
            return True
        if "_" not in known.name:
            return known.is_package and known.name in self._debian | self._fetched
        parts = known.name.split("_")
        ends = range(max(2, len(parts) - 2), len(parts) + 1)
        return any("_".join(parts[:end]) in self._installed for end in ends)

    def _has_beginning(self, begin: str) -> bool:
        """Whether a word of what installs begins so."""
        at = bisect_left(self._sorted, begin)
        return at < len(self._sorted) and self._sorted[at].startswith(begin)

    @cached_property
    def _fetches_installers(self) -> bool:
        return any(map(_INSTALLERS.search, self._fetched))

    @cached_property
    def _sorted(self) -> list[str]:
        return sorted(self._installed)

    def _is_of_pattern(self, known: Needed) -> bool:
        """Whether packages that are installed by a pattern may be it, or depend on it."""
        names = (known.name, *known.also)
        return any(
            len(begin) < _SHORT or known.comes_with(begin.rstrip("_")) or any(name.startswith(begin) for name in names)
            for begin in self._patterns
        )

    def has_repository(self, name: str) -> bool:
        """Whether a list of repositories or a command names a repository like a package."""
        return name.lower() in self._named

    def has_fork(self, package: str) -> bool:
        """Whether anything fetches the repository of a public package from others than those who release it, or
        patches it."""
        name = _repository(package)
        is_controller = name.endswith(_CONTROLLERS)
        return name in self._forks or (is_controller and any("controller" in each for each in self._forks))

    def fetches_older(self, package: str, release: str) -> bool:
        """Whether anything names what may be an older release than one, beside a public package or its repository."""
        names = "|".join(re.escape(each).replace("_", "[-_]") for each in (_repository(package), package))
        after = tuple(map(int, release.split(".")))
        return any(
            _may_be_before(text[max(0, match.start() - _BESIDE) : match.end() + _BESIDE], after)
            for text in self._installers.texts
            for match in re.finditer(names, text)
        )

    @cached_property
    def _forks(self) -> frozenset[str]:
        """The names of repositories that do not come from their first owners."""
        paths = (path.split("/") for text in self._installers.texts for path in ADDRESS.findall(text))
        owned = [name for parts in paths for owner, name in pairwise(parts) if owner not in _OWNERS]
        owned += [name for text in self._installers.texts for pair in _PATCHED.findall(text) for name in pair]
        return _plain(owned)

    @cached_property
    def _installed(self) -> frozenset[str]:
        """The words of what installs, with underscores, without the prefix of Debian packages."""
        words = (word for text in self._installers.texts for word in _words(text))
        return frozenset(words) | self._debian | self._fetched

    @cached_property
    def _fetched(self) -> frozenset[str]:
        """The repositories that something fetches."""
        return _plain(name for text in self._installers.texts for name in _REPOSITORY.findall(text))

    @cached_property
    def _debian(self) -> frozenset[str]:
        """What is named as a Debian package of ROS, which nobody names but to install it."""
        return _plain(name for text in self._installers.told for name in _PACKAGED.findall(text))

    @cached_property
    def _named(self) -> frozenset[str]:
        """What is named as a Debian package of ROS or as a repository, in commands and elsewhere."""
        return self._debian | _plain(name for text in self._installers.told for name in _REPOSITORY.findall(text))

    @cached_property
    def _variants(self) -> frozenset[str]:
        """The variants of ROS that packages and images have in their names."""
        return _plain(name for text in self._installers.told for name in _VARIANT.findall(text))

    @cached_property
    def _patterns(self) -> frozenset[str]:
        """How the names of packages begin that are installed by a pattern: what they depend on is not known."""
        found = (begin for text in self._installers.texts for begin in _PATTERN.findall(text))
        return frozenset(begin.replace("-", "_") if begin.isascii() and "$" not in begin else "" for begin in found)

    @cached_property
    def _foreign_images(self) -> bool:
        """Whether an image with ROS is built on one that others made, which may hold anything, and rosdep adds nothing
        to it."""
        files = (file for file in self._dockerfiles if _HAS_ROS.search(file.source.text))
        origins = {each.origin.lower() for file in files if not ROSDEP.search(file.source.text) for each in file.stages}
        return not all(map(is_plain, origins))


def _may_be_before(text: str, after: tuple[int, ...]) -> bool:
    """Whether a text names a release before another one, or a branch or commit of which the release is not known."""
    if any(tuple(map(int, each)) < after for each in _RELEASE.findall(text) if each[2]):
        return True
    named = {reference.rstrip(",;") for reference in _REFERENCE.findall(text)} - _NEWEST
    return "[submodule" in text or any(not _is_since(each, after) for each in named)


def _is_since(reference: str, after: tuple[int, ...]) -> bool:
    found = _RELEASE.search(reference)
    return found is not None and tuple(int(part or 999) for part in found.groups()) >= after


def _repository(package: str) -> str:
    """The repository that a public package comes with."""
    return next((repository for begin, repository in _SHARED if package.startswith(begin)), package)


def _plain(names: Iterable[str]) -> frozenset[str]:
    return frozenset(name.removesuffix(".git").replace("-", "_") for name in names)


def _words(text: str) -> Iterator[str]:
    for match in _WORD.finditer(text):
        word = match[0].replace("-", "_")
        yield word
        yield _PREFIX.sub("", word)
