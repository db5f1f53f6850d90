"""What packages of ROS bring of others when they are installed."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from bringup_lint.facts import rows
from bringup_lint.facts.ros.needed import base
from bringup_lint.pattern import regex

_SYSTEM = regex(r"^(?:python3?-|lib)|-|^(?:boost|curl|eigen|gtest|opencv|protobuf|sdl2|ament_|rosidl_|launch)")
"""rosdep keys of the system, and tools: they bring no package that nodes use."""


def brought_by(names: Iterable[str]) -> frozenset[str]:
    """The packages that come with others, as far as the table knows, numpy and Eigen among them."""
    todo, found = list(names), set[str]()
    while todo:
        for each in _brings().get(todo.pop(), ()):
            if each not in found:
                found.add(each)
                todo.append(each)
    return frozenset(found)


def is_known_to_bring(name: str) -> bool:
    """Whether the table has all that a dependency brings."""
    return name in _brings() or name in base() or _SYSTEM.search(name) is not None


@cache
def _brings() -> dict[str, tuple[str, ...]]:
    return {package: tuple(brings.split()) for package, brings in rows("ros/brought")[1]}
