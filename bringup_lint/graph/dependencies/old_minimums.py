"""Versions of CMake that a CMakeLists.txt asks for, and that CMake 4 no longer supports."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.workspace import Package

_ASKING = ("cmake_minimum_required", "cmake_policy")
_VERSION = regex(r"(\d+)\.(\d+)(?:\.\d+){0,2}\Z")
_LOWEST = (3, 5)
"""Source: release notes of CMake 4.0, "Deprecated and Removed Features"."""


def old_minimums(package: Package) -> Iterator[tuple[str, Located]]:
    """The first version of each CMakeLists.txt that is too low, with the command that asks for it. A range
    (``3.4...3.22``) counts by its end."""
    for build in package.builds:
        found = None
        if build.source.kind == "cmake" and "CMAKE_POLICY_VERSION_MINIMUM" not in build.source.text:
            asked = (each for each in commands(build.source) if each.name in _ASKING and not each.conditional)
            found = next(((each.name, each.arguments[1]) for each in asked if _is_old(each.arguments)), None)
        if found is not None:
            yield found


def _is_old(given: list[Located]) -> bool:
    if len(given) < 2 or given[0] != "VERSION":
        return False
    highest = _VERSION.match(given[1].rpartition("...")[2])
    return highest is not None and (int(highest[1]), int(highest[2])) < _LOWEST
