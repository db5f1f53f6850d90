"""The packages that a CMakeLists.txt requires in any case, also by a loop over a list of their names."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.parsers.cmake_commands import commands
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_VARIABLE = regex(r"^\$\{(\w+)\}$")
_IN = ("IN", "ITEMS", "LISTS")


def required_packages(source: Source) -> Iterator[tuple[Located, bool]]:
    """The names of ``find_package(... REQUIRED)`` outside of conditions and functions, and whether only the tests need
    them, in ``if(BUILD_TESTING)``."""
    lists: dict[str, list[Located]] = {}
    loop: tuple[str, list[Located]] | None = None
    in_tests = False
    for command in commands(source):
        name, given = command.name, command.arguments
        if name in ("if", "else", "elseif", "endif") and command.depth == (name in ("else", "elseif")):
            in_tests = name == "if" and given == ["BUILD_TESTING"]
        if name == "foreach" and given and not command.conditional:
            loop = (str(given[0]), _items(given[1:], lists))
        elif name == "endforeach" and not command.conditional:
            loop = None
        elif name == "find_package" and "REQUIRED" in given:
            if in_tests and command.depth == 1:
                yield given[0], True
            yield from ((each, False) for each in _found(command, loop))
        elif name == "set" and given:
            lists[str(given[0])] = [] if command.conditional else given[1:]
        elif name == "list" and len(given) > 1 and given[0] == "APPEND" and not command.conditional:
            lists[str(given[1])] = [*lists.get(str(given[1]), ()), *given[2:]]


def _found(command: Command, loop: tuple[str, list[Located]] | None) -> Iterator[Located]:
    """What a command looks for: a name, or all names that the loop around it goes through."""
    wanted = command.arguments[0]
    if not command.conditional:
        yield wanted
    elif loop is not None and command.depth == 1 and wanted == f"${{{loop[0]}}}":
        yield from loop[1]


def _items(given: list[Located], lists: dict[str, list[Located]]) -> list[Located]:
    """What ``foreach(variable ...)`` goes through, as far as it is known."""
    by_name = "LISTS" in given
    items: list[Located] = []
    for each in given:
        variable = _VARIABLE.match(each)
        if each in _IN:
            continue
        if by_name or variable:
            items += lists.get(variable[1] if variable else str(each), ())
        else:
            items.append(each)
    return [each for each in items if each.replace("_", "").isalnum()]
