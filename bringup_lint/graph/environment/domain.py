"""The DDS domain of the robot, as its files set it."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.files import Files

_DOMAIN = regex(r"^[^#\n]*?\bROS_DOMAIN_ID[\"']?[ \t]*[=:][ \t]*[\"']?(\d{1,3})\b", re.M, hints="ROS_DOMAIN_ID")


def agreed_domain(files: Files, ros: RosEnvironment) -> tuple[int, Located] | None:
    """The domain of the robot's units when they agree on one; where they set none, the one that all files agree on."""
    found = _of_units(ros)
    if found:
        return next(iter(found.items())) if len(found) == 1 else None
    for source in files.sources:
        if not source.judged:
            continue
        for match in _DOMAIN.finditer(source.text):
            found.setdefault(int(match[1]), source.located(match.start(1), match.end(1)))
    return next(iter(found.items())) if len(found) == 1 else None


def _of_units(ros: RosEnvironment) -> dict[int, Located]:
    found: dict[int, Located] = {}
    for process in ros.processes:
        variable = process.environment.get("ROS_DOMAIN_ID") if process.unit else None
        if variable is not None and variable.text is not None and re.fullmatch(r"\d{1,3}", variable.text):
            found.setdefault(int(variable.text), variable.value)
    return found
