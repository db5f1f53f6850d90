"""Recognising what a file is: one module a family, first claim wins.

A kind looks at the path first and reads the head of the file only when the path does not decide. What merely looks
alike (polkit's ``.rules``, a docs folder called ``ros2.service``) must not be claimed.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

from bringup_lint.named_tuple import NamedTuple

HEAD_SIZE = 8192
"""How much of a file, in bytes, a kind may look at."""

Head = Callable[[], str]
"""Gives the first HEAD_SIZE bytes as text, read on the first call."""


class Kind(NamedTuple):
    """A kind of file: its name, and whether a path (with ``/``) and the head of the file are of it."""

    name: str
    claims: Callable[[str, Head], bool]


@lru_cache
def kinds() -> tuple[Kind, ...]:
    """All kinds, in the order of the modules' names: path tests are exclusive, so the order does not matter."""
    modules = sorted(path.stem for path in Path(__file__).parent.glob("*.py") if not path.stem.startswith("_"))
    return tuple(kind for name in modules for kind in importlib.import_module(f"{__name__}.{name}").KINDS)


def kind_of(path: str, head: Head) -> str:
    """The name of the kind that claims the file, or an empty string."""
    for kind in kinds():
        if kind.claims(path, head):
            return kind.name
    return ""
