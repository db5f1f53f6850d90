"""Packages that distributions of ROS 2 no longer have, and the executables of common packages."""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cache

from bringup_lint.facts import table
from bringup_lint.facts.ros.distros import every
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.spelling import nearest

ROS1 = "ros1"


class Program(NamedTuple):
    name: str
    """A name, or a pattern of names."""
    last: str
    """The last distribution that has it under this name; empty when all do."""
    now: str
    """Its name since."""


class PublicPackage(NamedTuple):
    name: str
    last: str
    """The last distribution that has it, ``ros1``, or empty when all have it."""
    programs: tuple[Program, ...]
    """Empty when they are not known."""
    instead: str
    repository: str = ""
    """The repository with its sources, when it has another name."""

    def is_gone(self, distro: str | None) -> bool:
        return self.last == ROS1 or _is_after(distro, self.last)

    def lacks(self, program: str) -> bool:
        """Whether no distribution has an executable of the name."""
        return bool(self.programs) and not any(fnmatchcase(program, each.name) for each in self.programs)

    def renamed(self, program: str, distro: str | None) -> Program | None:
        """The executable that has another name in a distribution."""
        found = next((each for each in self.programs if each.name == program), None)
        return found if found is not None and _is_after(distro, found.last) else None


def _is_after(distro: str | None, last: str) -> bool:
    order = list(every())
    return distro in order and last in order and order.index(distro) > order.index(last)


def public_package(name: str) -> PublicPackage | None:
    return _all().get(name)


def package_meant(name: str, program: str) -> str | None:
    """The one common package with a program that a name nobody has stands for: it is that of one of its programs, or
    nearly that of the package."""
    having = [each for each in _all().values() if any(program == own.name for own in each.programs)]
    if len(having) != 1 or name == having[0].name:
        return None
    package = having[0]
    is_program = any(each.name == name for each in package.programs)
    return package.name if is_program or nearest(name, [package.name]) else None


@cache
def _all() -> dict[str, PublicPackage]:
    return {
        row["package"]: PublicPackage(
            row["package"],
            row["last"],
            tuple(map(_program, row["programs"].split())),
            row["instead"],
            row["repository"],
        )
        for row in table("ros/public_programs")
    }


def _program(text: str) -> Program:
    name, _, rest = text.partition("@")
    last, _, now = rest.partition(">")
    return Program(name, last, now)
