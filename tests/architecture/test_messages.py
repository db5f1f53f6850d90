"""What is said to a person at a terminal goes through ``cli.streams``, which shows control characters as signs."""

from __future__ import annotations

import re

from tests.architecture.imports import PACKAGE

DIRECT = re.compile(r"err=True|file=sys\.stderr|sys\.stderr\.write")
ELSEWHERE = {
    "cli/streams.py": "the one place",
    "cli/commands/fleet.py": "counts how far it is, in numbers",
    "live/observe.py": "another process, whose words are read and shown by cli.commands.live",
}


def test_messages_are_said_in_one_place() -> None:
    names = (path for path in PACKAGE.rglob("*.py") if DIRECT.search(path.read_text("utf-8")))
    assert {path.relative_to(PACKAGE).as_posix() for path in names} == set(ELSEWHERE)
