"""Commands of scripts whose failure is expected."""

from __future__ import annotations

import re
from functools import lru_cache

from bringup_lint.model.shell import Command
from bringup_lint.pattern import regex

_TESTS = regex(
    r"(?:\[|\btest)[ \t][^\n]{0,40}-[efsx][ \t]|\b(?:command -v|which|type)[ \t]"
    r"|\b(?:if|while|until)[ \t][^\n;]{0,80}\bros2[ \t]"
)
"""Whether there is a file, or a program, or what a command ends with."""
_ASKS = regex(
    r"\bros2[ \t]+pkg[ \t][^\n|&>)]*[|&>]|\b(?:if|elif|while|until)\b[^\n]{0,80}\bros2[ \t]+pkg[ \t]", hints="ros2"
)
"""A line that asks for a package, and does something else where it is not there."""


def is_forgiven(command: Command) -> bool:
    """Whether another command runs when this one fails, or nobody sees what it says."""
    return command.ends == "||" or any(each.target == "/dev/null" for each in command.redirects)


def may_fail(command: Command, name: str) -> bool:
    """Whether nobody minds that a command fails, or its script asks before for what the command names."""
    if is_forgiven(command):
        return True
    named = re.compile(rf"\b{re.escape(name)}\b")
    return any(_ASKS.search(line) or named.search(line) for line in _tests(command.words[0].span.source.text))


@lru_cache(maxsize=1)
def _tests(text: str) -> tuple[str, ...]:
    """The lines of a script with a test, for all of its commands in a row."""
    return tuple(line for line in text.splitlines() if _TESTS.search(line) or _ASKS.search(line))
