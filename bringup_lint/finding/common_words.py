"""Words that tell nobody a secret where they stand alone: those of the field, and of the paths that a report shows.

A robot called panther whose password is ``panther`` too is still called so in every message.
"""

from __future__ import annotations

from collections.abc import Iterable

from bringup_lint.pattern import regex
from bringup_lint.source import Source

_WORD = regex(r"[a-z]{1,16}\d{0,2}")
_PART = regex(r"[a-z]+\d*|\d+")
_OF_FIELD = frozenset(
    """
    administrator camera clearpath client controller debian default docker driver franka galactic gazebo gripper
    humble husarion jetson kilted launch navigation network nvidia operator panther pixhawk public raspberry raspbian
    robotics robots rolling rosbot sensor server service simulation system turtlebot turtlebot3 turtlebot4 ubuntu
    unitree waveshare
    """.split()
)


def parts_of_paths(sources: Iterable[Source]) -> frozenset[str]:
    """The words of the paths of files."""
    return frozenset(part for source in sources for part in _PART.findall(source.name.lower()))


def is_common(secret: str, parts: frozenset[str]) -> bool:
    """Whether a value is such a word; ``parts`` are those of the paths."""
    word = secret.lower()
    return _WORD.fullmatch(word) is not None and (word in _OF_FIELD or word in parts)
