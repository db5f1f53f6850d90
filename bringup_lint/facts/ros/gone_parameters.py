"""Parameters and launch arguments of public packages that newer releases have under other names."""

from __future__ import annotations

from collections.abc import Container
from functools import cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple


class Gone(NamedTuple):
    package: str
    since: str
    """The release of the package that dropped the name."""
    older: tuple[str, ...]
    """Distributions whose packages are older."""
    now: str
    """The name that does the same."""
    named: str
    """The release of the package that has this name."""

    def is_for(self, named: Container[str]) -> bool:
        """Whether none of the distributions that a tree names has an older release."""
        return not any(each in named for each in self.older)


def gone_parameter(package: str, program: str, name: str) -> Gone | None:
    """By the executable or the component class of a node."""
    return _by_owner("programs").get((package, program, name))


def gone_argument(package: str, file: str, name: str) -> Gone | None:
    """By the name of a launch file."""
    return _by_owner("launches").get((package, file, name))


@cache
def _by_owner(column: str) -> dict[tuple[str, str, str], Gone]:
    return {
        (row["package"], owner, name): Gone(
            row["package"], row["since"], tuple(row["older"].split()), row["now"], row["named"]
        )
        for row in table("ros/gone_parameters")
        for owner in row[column].split()
        for name in row["was"].split()
    }
