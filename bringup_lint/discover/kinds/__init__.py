"""Recognising what a file is: one module a family, first claim wins.

A kind looks at the path first and reads the head of the file only when the path does not decide. What merely looks
alike (polkit's ``.rules``, a docs folder called ``ros2.service``) must not be claimed.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import lru_cache
from importlib import import_module

from bringup_lint.named_tuple import NamedTuple

HEAD_SIZE = 8192
"""How much of a file, in bytes, a kind may look at."""

Head = Callable[[], str]
"""Gives the first HEAD_SIZE bytes as text, read on the first call."""


class Kind(NamedTuple):
    """A kind of file: its name, and whether a path (with ``/``) and the head of the file are of it."""

    name: str
    claims: Callable[[str, Head], bool]
    word: str = ""
    """What each path of the kind holds, which is looked for first: most files are of none."""


UNIT_TYPES = (
    "service",
    "socket",
    "target",
    "timer",
    "path",
    "mount",
    "automount",
    "swap",
    "slice",
    "scope",
    "device",
)
_USUAL = dict.fromkeys(UNIT_TYPES, "systemd")
"""Extension -> the module that claims most files with it. It is asked first, so that the others need not be loaded."""


@lru_cache
def kinds() -> tuple[Kind, ...]:
    """All kinds, in the order of the modules' names: path tests are exclusive, so the order does not matter."""
    modules = sorted(name[:-3] for name in os.listdir(os.path.dirname(__file__)) if name.endswith(".py"))
    return tuple(kind for name in modules if not name.startswith("_") for kind in _of_module(name))


def kind_of(path: str, head: Head) -> str:
    """The name of the kind that claims the file, or an empty string."""
    usual = _USUAL.get(path.rpartition(".")[2])
    return (usual and _claim(_of_module(usual), path, head)) or _claim(kinds(), path, head)


def _of_module(name: str) -> tuple[Kind, ...]:
    return tuple(import_module(f"{__name__}.{name}").KINDS)


def _claim(asked: tuple[Kind, ...], path: str, head: Head) -> str:
    for name, claims, word in asked:
        if word in path and claims(path, head):
            return name
    return ""
