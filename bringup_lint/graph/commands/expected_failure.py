"""Commands of scripts whose failure is expected."""

from __future__ import annotations

import re

from bringup_lint.model.shell import Command
from bringup_lint.pattern import regex

_TESTS = regex(
    r"(?:\[|\btest)[ \t][^\n]{0,40}-[efsx][ \t]|\b(?:command -v|which|type)[ \t]"
    r"|\b(?:if|while|until)[ \t][^\n;]{0,80}\bros2[ \t]"
)
"""Whether there is a file, or a program, or what a command ends with."""
_ASKS = regex(r"\bros2[ \t]+pkg[ \t]")


def may_fail(command: Command, name: str) -> bool:
    """Whether nobody minds that a command fails, or its script asks before for what the command names."""
    text = command.words[0].span.source.text
    named = re.compile(rf"\b{re.escape(name)}\b")
    tested = any(named.search(line) and _TESTS.search(line) for line in text.splitlines() if name in line)
    unheard = any(each.target == "/dev/null" for each in command.redirects)
    return unheard or tested or command.ends == "||" or _ASKS.search(text) is not None
