"""A sample of ``benchmarks/growth.py``: the time of a run grows as the size of one file does, whatever is repeated in
it."""

from __future__ import annotations

import importlib.util
import random
import sys
from functools import cache
from types import ModuleType
from typing import Any

import pytest

from bringup_lint.discover.kinds import kinds
from bringup_lint.registry import Registry
from tests.conftest import PROJECT
from tests.growth import is_linear

ALWAYS, ALL = 2, 60
"""Combinations that are always tried, and those of a campaign."""
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


@cache
def every() -> list[Any]:
    return sorted(GROWTH.combinations())


def tried() -> list[Any]:
    marks = [() if number < ALWAYS else (pytest.mark.campaign,) for number in range(ALL)]
    return [pytest.param(number, marks=mark) for number, mark in enumerate(marks)]


@pytest.mark.parametrize("number", tried())
def test_a_run_takes_time_as_the_size_of_a_file(number: int) -> None:
    registry = Registry.of()
    each = random.Random(SEED).sample(every(), ALL)[number]
    assert is_linear(lambda size: GROWTH.judge(each.name, each.of(size), registry), SMALL), each


GREW = [
    ("cron", "@reboot robot /opt/robot/start\n"),
    ("python-node", "    rclpy.init()\n"),
    ("systemd-dropin", "ReadWritePaths=/var/log/heron /var/lib/heron /tmp\n"),
    ("launch-xml", '    <arg name="robot" value="$(var robot)"/>\n'),
    ("params", "      scan: anything\n"),
    ("cyclonedds", '      <Thread Name="receiver"/>\n'),
    ("dockerfile", "RUN <<EOF\n"),
    ("systemd-dropin", "a=b\n"),
    ("cpp-node", "<!-- "),
]
"""What once took more than its share."""


@pytest.mark.campaign
@pytest.mark.parametrize(("kind", "unit"), GREW)
def test_what_grew_too_much_grows_no_more(kind: str, unit: str) -> None:
    name, text = GROWTH.samples()[kind]
    each = GROWTH.Combination(kind, name, text, unit)
    registry = Registry.of()
    assert is_linear(lambda size: GROWTH.judge(each.name, each.of(size), registry), SMALL)


@pytest.mark.slow
def test_every_kind_is_tried() -> None:
    """Every kind has a short file among the fixtures."""
    assert {kind.name for kind in kinds()} <= {each.kind for each in every()}


def test_what_grows_too_much_is_noticed() -> None:
    assert GROWTH.is_superlinear([0.1, 6.4])
    assert GROWTH.is_superlinear([0.1, float("inf")])
    assert not GROWTH.is_superlinear([0.1, 0.8, 6.4])
    assert not GROWTH.is_superlinear([0.001, 0.1])


def test_a_step_that_takes_more_than_its_share_is_followed() -> None:
    assert GROWTH.is_suspicious([0.1, 1.2])
    assert GROWTH.is_suspicious([0.1, 0.8], alone=0.05)
    assert not GROWTH.is_suspicious([0.1, 0.8])
    assert not GROWTH.is_suspicious([0.001, 0.05])


@pytest.mark.slow
def test_the_parts_of_a_sweep_are_all_of_it() -> None:
    kinds = ["journald", "udev-rules"]
    parts = [each for part in ("1/3", "2/3", "3/3") for each in GROWTH.chosen(kinds, part)]
    assert sorted(parts) == [each for each in every() if each.kind in kinds]
