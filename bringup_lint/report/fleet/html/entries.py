"""What the parts of the page share: how an entry is found, and what a robot is called."""

from __future__ import annotations

from bringup_lint.fleet.summary import Summary
from bringup_lint.report.html.markup import text


def found_by(*words: str) -> str:
    """The attribute by which the search of the page finds an entry."""
    return f'data-words="{text(" ".join(words).lower())}"'


def words_of(robot: Summary) -> str:
    return f"{robot.name} {role_of(robot)}"


def role_of(robot: Summary) -> str:
    return f"{robot.role} at {robot.site}" if robot.site else robot.role
