"""Functions and macros that files of CMake define, and the values that a call gives their variables (cmake-language(7);
cmake-commands(7): function, macro, cmake_parse_arguments)."""

from __future__ import annotations

from collections.abc import Sequence

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.cmake_commands import Command
from bringup_lint.source import Located

DEEPEST = 8
"""Calls within each other."""


class Definition(NamedTuple):
    """A function or macro."""

    is_macro: bool
    """What it sets stays set."""
    parameters: tuple[str, ...]
    body: tuple[Command, ...]
    """With depths that count from the definition."""

    def called(self, command: Command) -> list[Command]:
        """The commands that a call runs."""
        return [Command(each.name, each.arguments, each.depth + command.depth) for each in self.body]


def defined(given: Sequence[Command], at: int, end: int) -> Definition | None:
    """The function whose first and last command are at these places; None for one without a name."""
    first = given[at]
    if not first.arguments:
        return None
    body = (Command(each.name, each.arguments, each.depth - first.depth - 1) for each in given[at + 1 : end])
    return Definition(first.name == "macro", tuple(map(str, first.arguments[1:])), tuple(body))


def bound(parameters: Sequence[str], words: Sequence[Located | None]) -> dict[str, str | None]:
    """The variables of a call: None where a value is not known."""
    rest = words[len(parameters) :]
    found: dict[str, str | None] = {"ARGC": str(len(words)), "ARGV": _list(words), "ARGN": _list(rest)}
    found.update((f"ARGV{at}", word) for at, word in enumerate(words))
    found.update(zip(parameters, words))
    return found


def _list(words: Sequence[Located | None]) -> str | None:
    known = [word for word in words if word is not None]
    return None if len(known) < len(words) else ";".join(known)


def parsed(
    prefix: str, options: Sequence[str], single: Sequence[str], several: Sequence[str], words: Sequence[str] | None
) -> dict[str, str | None]:
    """The variables that ``cmake_parse_arguments`` sets; all are unknown where a word is."""
    keys = (*options, *single, *several)
    if words is None:
        return {f"{prefix}_{key}": None for key in (*keys, "UNPARSED_ARGUMENTS")}
    taken: dict[str, list[str]] = {}
    current = "UNPARSED_ARGUMENTS"
    for word in words:
        if word in options:
            taken[word], current = ["TRUE"], "UNPARSED_ARGUMENTS"
        elif word in single or word in several:
            taken[word], current = [], word
        else:
            taken.setdefault(current, []).append(word)
            current = "UNPARSED_ARGUMENTS" if current in single else current
    found = {f"{prefix}_{key}": "FALSE" if key in options else "" for key in (*keys, "UNPARSED_ARGUMENTS")}
    return {**found, **{f"{prefix}_{key}": ";".join(values) for key, values in taken.items()}}


def is_quoted(argument: Located) -> bool:
    """Whether an argument is between quotes, so that a list in it stays one word."""
    span = argument.span
    return span.source.text[span.start - 1 : span.start] == '"'
