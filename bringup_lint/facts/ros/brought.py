"""What packages of ROS bring of others when they are installed."""

from __future__ import annotations

from collections.abc import Iterable
from functools import cache

from bringup_lint.facts import rows


def brought_by(names: Iterable[str]) -> frozenset[str]:
    """The packages that come with others, as far as the table knows, numpy and Eigen among them."""
    todo, found = list(names), set[str]()
    while todo:
        for each in _brings().get(todo.pop(), ()):
            if each not in found:
                found.add(each)
                todo.append(each)
    return frozenset(found)


def is_released(name: str) -> bool:
    """Whether the table knows a package."""
    return name in brought_packages()


@cache
def lists() -> frozenset[str]:
    """The packages of which the table has all that they bring of others that it knows."""
    return frozenset(_brings())


@cache
def brought_packages() -> frozenset[str]:
    """All packages that the table knows."""
    return frozenset(_brings()).union(*_brings().values())


@cache
def _brings() -> dict[str, tuple[str, ...]]:
    return {package: tuple(brings.split()) for package, brings in rows("ros/brought")[1]}
