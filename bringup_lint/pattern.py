"""Patterns that are compiled when they are first asked. The modules of a run hold some hundred, and most are never
asked: to compile them all takes as long as the rest of a small run."""

from __future__ import annotations

import re
from typing import Any
from typing import AnyStr
from typing import cast


class Uncompiled:
    """Stands for a pattern. What is asked of it once is kept, so that asking again costs nothing."""

    __slots__ = (
        "findall",
        "finditer",
        "flags",
        "fullmatch",
        "groupindex",
        "groups",
        "match",
        "pattern",
        "search",
        "split",
        "sub",
        "subn",
    )

    def __init__(self, pattern: str | bytes, flags: int) -> None:
        self.pattern = pattern
        self.flags = flags

    def __getattr__(self, name: str) -> Any:
        value = getattr(re.compile(self.pattern, self.flags), name)
        object.__setattr__(self, name, value)
        return value


def regex(pattern: AnyStr, flags: int = 0) -> re.Pattern[AnyStr]:
    """A pattern for a module to hold. It has the methods of a compiled one; the functions of ``re`` do not take it."""
    return cast("re.Pattern[AnyStr]", Uncompiled(pattern, flags))
