"""Checks of fleets collect garbage after each robot."""

from __future__ import annotations

import pytest


@pytest.fixture(scope="module", autouse=True)
def heap_is_settled(settled: None) -> None:
    """What other tests left is not looked through again and again."""
