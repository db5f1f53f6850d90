"""How often a loop of a shell script goes round."""

from __future__ import annotations

import pytest

from bringup_lint.graph.systemd.loops import Names
from bringup_lint.graph.systemd.loops import rounds
from bringup_lint.parsers.shell import blocks
from bringup_lint.parsers.systemd_values import nowhere


@pytest.mark.parametrize(
    ("words", "count"),
    [
        ("1 2 3", 3),
        ("$(seq 1 5)", 5),
        ("$(seq 1 2 5)", 3),
        ("$(seq 5)", 5),
        ("$(seq 1 $N)", 0),
        ("{1..4}", 4),
        ("$UNKNOWN", 0),
        ("*.yaml", 0),
    ],
)
def test_rounds(words: str, count: int) -> None:
    (block,) = (each for each in blocks(nowhere(f"for i in {words}; do sleep 1; done")) if each.items)
    assert rounds(block, Names()) == count
