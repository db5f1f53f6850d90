"""Packages, Python modules and libraries that ros-base lacks, and what brings them."""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cache

from bringup_lint.facts import rows
from bringup_lint.facts import table
from bringup_lint.facts.ros import distros
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.spelling import edits
from bringup_lint.spelling import numbered

_DEBIAN = regex(rf"^ros-(?:{'|'.join(distros.every())})-[a-z0-9-]+$")
"""The Debian package of a package of ROS, which is no rosdep key."""
_MESSAGES = ("_msgs", "_interfaces")


class Needed(NamedTuple):
    is_package: bool
    name: str
    key: str
    """The rosdep key; empty when rosdep knows none."""
    also: tuple[str, ...]
    """The other names that bring it, by patterns, and after ``!`` what does not bring it in spite of its name. Patterns
    with a star in front are for names of dependencies alone."""

    def comes_with(self, dependency: str) -> bool:
        """Whether a dependency brings it. Packages of messages bring nothing but messages."""
        found = dependency.replace("-", "_")
        if found in (self.name, self.key.replace("-", "_")):
            return True
        if f"!{found}" in self.also or (found.endswith(_MESSAGES) and not self.name.endswith(_MESSAGES)):
            return False
        return any(fnmatchcase(found, each) for each in self.also)

    @property
    def declared(self) -> str:
        """What a package.xml declares; empty when rosdep knows no key."""
        return self.key or (self.name if self.is_package else "")

    @property
    def words(self) -> frozenset[str]:
        """The plain names, with underscores."""
        names = (self.key.replace("-", "_"), *self.also)
        return frozenset(each for each in names if each and "*" not in each and "!" not in each)

    @property
    def beginnings(self) -> tuple[str, ...]:
        """How the names of packages begin that bring it."""
        return tuple(each[:-1] for each in self.also if each.find("*") == len(each) - 1)


@cache
def _by_name() -> dict[tuple[str, str], Needed]:
    return {
        (row["use"], row["name"]): Needed(row["use"] == "package", row["name"], row["key"], tuple(row["also"].split()))
        for row in table("ros/needed")
    }


def needed(use: str, name: str) -> Needed | None:
    """``use``: ``package``, ``module`` or ``library``; None when nothing is known of the name."""
    own = _by_name().get((use, name))
    if own is not None:
        return own
    family = _by_name().get((use, f"{name.partition('_')[0]}_*"))
    return family and family._replace(name=name)


COMMON = {
    "click": "python3-click",
    "cryptography": "python3-cryptography",
    "lxml": "python3-lxml",
    "netifaces": "python3-netifaces",
    "numpy": "python3-numpy",
    "packaging": "python3-packaging",
    "pkg_resources": "python3-pkg-resources",
    "psutil": "python3-psutil",
    "requests": "python3-requests",
    "yaml": "python3-yaml",
    "Boost": "boost",
    "CURL": "curl",
    "Eigen3": "eigen",
    "OpenSSL": "libssl-dev",
    "SQLite3": "libsqlite3-dev",
    "TBB": "tbb",
    "fmt": "fmt",
    "nlohmann_json": "nlohmann-json-dev",
    "spdlog": "spdlog",
    "yaml-cpp": "yaml-cpp",
}
"""Modules and libraries that most robots have, and their keys."""
_OF_ROS_BASE = frozenset(
    "python3-click python3-cryptography python3-lxml python3-netifaces python3-numpy python3-packaging"
    " python3-pkg-resources python3-psutil python3-requests python3-yaml eigen libssl-dev spdlog yaml-cpp".split()
)


def of_ros_base() -> frozenset[str]:
    """The keys of these that the packages of ros-base, or Ubuntu, bring."""
    return _OF_ROS_BASE


@cache
def of_key(key: str) -> Needed:
    """What is known of what a package.xml declares so."""
    found = (each for each in _by_name().values() if each.declared == key)
    return next(found, Needed(True, key, key, ()))


@cache
def base() -> frozenset[str]:
    """The packages of ros-base."""
    return frozenset(row[0] for row in rows("ros/base")[1])


_OTHERS = frozenset(("ament_cmake_test", "nav2_msgs", "rclc_lifecycle", "ros2nodl", "rosbot_localization", "spacenavd"))
"""Released packages and keys that are a letter away from a package that the tables know."""
_LONG = 8
"""Letters from which on a name that is one letter away can mean nothing else."""
_WORD = 6
"""Letters from which on a word that is one letter away is the same one."""


def is_debian_package(name: str) -> bool:
    """Whether a name is one of a package of ROS for apt."""
    return _DEBIAN.match(name) is not None


@cache
def instead_of(name: str) -> str | None:
    """What to write instead of a name that rosdep cannot resolve, empty for nothing; None when it may be known."""
    if name in not_rosdep():
        return not_rosdep()[name]
    if is_debian_package(name):
        return name.split("-", 2)[2].replace("-", "_")
    known = {*base(), *(each for use, each in _by_name() if use == "package")}
    if name in known or name in _OTHERS or len(name) < _LONG:
        return None
    if name.replace("-", "_") in known:
        return name.replace("-", "_")
    near = [each for each in known if len(each) >= _LONG and edits(name, each, 1) == 1]
    return near[0] if len(near) == 1 and _is_misspelt(name, near[0]) else None


def _is_misspelt(name: str, known: str) -> bool:
    """Whether a name one letter away is no name of its own: ``uav_msgs`` is a package, ``rplidar_ros2`` a fork."""
    if numbered(name, known):
        return False
    pairs = list(zip(name.split("_"), known.split("_")))
    if name.count("_") != known.count("_"):
        return True
    return all(one == other or len(other) >= _WORD or f"{one}s" == other for one, other in pairs)


@cache
def not_rosdep() -> dict[str, str]:
    """The names that rosdep cannot resolve, with what to write instead, if anything."""
    return {row["name"]: row["instead"] for row in table("ros/not_rosdep")}


class Unresolved(NamedTuple):
    """What rosdep says of a name."""

    error: str
    ended: bool
    """Only from Ubuntu 22.04 on."""
    is_late: bool
    """apt says it, when rosdep already installs."""


_SAYS = {
    "": "Cannot locate rosdep definition for [{}]",
    "version": "No definition of [{}] for OS version",
    "apt": "Unable to locate package {}",
}


@cache
def unresolved(name: str) -> Unresolved:
    """Why rosdep does not install what has this name."""
    error = _errors().get(name, "")
    return Unresolved(_SAYS[error].format(name), bool(error), error == "apt")


@cache
def _errors() -> dict[str, str]:
    return {row["name"]: row["error"] for row in table("ros/not_rosdep")}
