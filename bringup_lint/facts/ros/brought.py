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
    return name in _brings() or name in _packages()


@cache
def _packages() -> frozenset[str]:
    return frozenset(each for brought in _brings().values() for each in brought)


@cache
def _brings() -> dict[str, tuple[str, ...]]:
    return {package: tuple(brings.split()) for package, brings in rows("ros/brought")[1]}
