"""A sample of the fixtures for quick runs; the rest is left to the long ones."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from zlib import crc32

import pytest


def sampled(cases: Iterable[tuple[str, Path]], every: int, rest: pytest.MarkDecorator) -> list[object]:
    """The fixtures, with a mark on all but about one of so many. Their own names say which, so that a new fixture
    changes nothing for the others."""
    return [pytest.param(*case, marks=() if _drawn(*case, every) else rest) for case in cases]


def _drawn(rule_id: str, case: Path, every: int) -> bool:
    return crc32(f"{rule_id}/{case.name}".encode()) % every == 0
