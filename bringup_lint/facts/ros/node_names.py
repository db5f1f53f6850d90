"""The topics, services and actions of nodes of public packages: what a remapping of them may name."""

from __future__ import annotations

from fnmatch import fnmatchcase
from functools import cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple


class NodeNames(NamedTuple):
    """All names that a program uses, besides those that every node has."""

    patterns: tuple[str, ...]
    by_parameters: bool
    """Parameters name topics, too."""
    fixed: str = ""
    """A pattern of names that no parameter gives."""

    def has(self, name: str) -> bool:
        """Whether a name, without what it begins with, is one of them in any namespace."""
        return any(fnmatchcase(name, pattern) or fnmatchcase(name, f"*/{pattern}") for pattern in self.patterns)

    def may_be_given(self, name: str) -> bool:
        """Whether a parameter of the program may give a topic this name."""
        return self.by_parameters and not fnmatchcase(name.rpartition("/")[2], self.fixed)

    @property
    def plain(self) -> list[str]:
        return [pattern for pattern in self.patterns if "*" not in pattern]


def node_names(package: str, program: str) -> NodeNames | None:
    """``program``: an executable or component class; None when its names are not all known."""
    return _all().get((package, program))


@cache
def _all() -> dict[tuple[str, str], NodeNames]:
    return {
        (row["package"], program): NodeNames(
            tuple(row["names"].split()), row["parameters"] != "no", row["parameters"].partition("not ")[2]
        )
        for row in table("ros/node_names")
        for program in row["programs"].split()
    }
