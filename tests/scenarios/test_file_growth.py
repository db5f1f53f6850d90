"""A sample of ``benchmarks/growth.py``: the time of a run grows as the size of one file does, whatever is repeated in
it."""

from __future__ import annotations

import importlib.util
import random
import sys
from types import ModuleType
from typing import Any

import pytest

from bringup_lint.registry import Registry
from tests.conftest import PROJECT
from tests.growth import is_linear

QUICK, ALL = 6, 60
"""Combinations of a quick run, and of a whole one."""
SMALL = 8 * 1024
"""Bytes of the smaller file."""


def benchmark() -> ModuleType:
    """``benchmarks/growth.py``, which is no package."""
    spec = importlib.util.spec_from_file_location("growth_benchmark", PROJECT / "benchmarks/growth.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


GROWTH = benchmark()
SEED = 1


def tried() -> list[Any]:
    every = sorted(GROWTH.combinations())
    chosen = random.Random(SEED).sample(every, ALL)
    names = [f"{each.kind}-{each.unit[:20]!r}" for each in chosen]
    marks = [() if number < QUICK else (pytest.mark.slow,) for number in range(ALL)]
    return [pytest.param(each, id=name, marks=mark) for each, name, mark in zip(chosen, names, marks)]


@pytest.mark.parametrize("combination", tried())
def test_a_run_takes_time_as_the_size_of_a_file(combination: Any) -> None:
    registry = Registry.of()
    assert is_linear(lambda size: GROWTH.judge(combination.name, combination.of(size), registry), SMALL)


def test_every_kind_is_tried() -> None:
    from bringup_lint.discover.kinds import kinds

    missing = {kind.name for kind in kinds()} - {each.kind for each in GROWTH.combinations()}
    assert missing <= set(), "a kind without a short file among the fixtures"


def test_what_grows_too_much_is_noticed() -> None:
    assert GROWTH.is_superlinear([0.1, 0.4, 1.6, 6.4])
    assert GROWTH.is_superlinear([0.1, float("inf")])
    assert not GROWTH.is_superlinear([0.1, 0.2, 0.4, 0.8])
