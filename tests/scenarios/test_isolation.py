"""Whatever fails on one source, in a parser, a layer or a rule: the findings on all other sources still come."""

from __future__ import annotations

import functools
import importlib
import inspect
import pkgutil
import random
import shutil
import sys
from collections import defaultdict
from collections.abc import Callable
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from pathlib import Path
from typing import Any

import pytest

import bringup_lint.graph
import bringup_lint.parsers
from bringup_lint.config import Config
from bringup_lint.discover.walk import discover
from bringup_lint.engine import Outcome
from bringup_lint.engine import run
from bringup_lint.finding import Finding
from bringup_lint.isolation import INTERNAL_ERROR
from bringup_lint.isolation import _source_of
from bringup_lint.registry import Registry
from bringup_lint.robot import Robot
from tests.conftest import PROJECT

pytestmark = pytest.mark.slow

TREE = PROJECT / "fixtures/robots/guide/tree"
SAMPLE = 12


class Planted(Exception):
    pass


@dataclass
class Plant:
    """Makes one function fail on one source."""

    function: str = ""
    source: str = ""
    seen: dict[str, set[str]] = field(default_factory=lambda: defaultdict(set))
    """Function -> the sources that it was called with."""
    is_ahead: bool = False
    """What a report may ask for is made ahead, and what fails there fails again when a report asks for it."""

    def wrapped(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        @functools.wraps(function)
        def call(*arguments: Any, **named: Any) -> Any:
            for value in (*arguments, *named.values()):
                source = _source_of(value)
                if source is not None and not self.is_ahead:
                    self.seen[name].add(source.name)
                    if self.function == name and source.name == self.source and source.text:
                        raise Planted
            return function(*arguments, **named)

        return call


def modules(*packages: Any) -> Iterator[Any]:
    for package in packages:
        for found in pkgutil.walk_packages(package.__path__, f"{package.__name__}."):
            yield importlib.import_module(found.name)


@pytest.fixture(scope="module")
def plant() -> Iterator[Plant]:
    """Every function of the parsers and layers can be made to fail."""
    planted, patch = Plant(), pytest.MonkeyPatch()
    wrapped: dict[Any, Any] = {}
    for module in list(modules(bringup_lint.parsers, bringup_lint.graph)):
        for name, function in inspect.getmembers(module, inspect.isfunction):
            if function.__module__ == module.__name__ and not name.startswith("__"):
                wrapped[function] = planted.wrapped(f"{module.__name__}.{name}", function)
    for module in [each for name, each in sys.modules.items() if name.startswith("bringup_lint.")]:
        for name, value in list(vars(module).items()):
            if inspect.isfunction(value) and value in wrapped:
                patch.setattr(module, name, wrapped[value])
    make_ahead = Robot.let_go_of_syntax

    def let_go_of_syntax(robot: Robot) -> None:
        planted.is_ahead = True
        try:
            make_ahead(robot)
        finally:
            planted.is_ahead = False

    patch.setattr(Robot, "let_go_of_syntax", let_go_of_syntax)
    yield planted
    patch.undo()


def checked(folder: Path) -> Outcome:
    tree = discover((str(folder),), root=str(folder))
    return run(Robot(tree), Registry.of(), Config(min_severity="info"))


def mark(found: Finding) -> tuple[str, str, int, str]:
    return (found.rule, found.span.path, found.span.start, found.message)


def concerns(found: Finding, name: str) -> bool:
    places = (found.span, *(each.span for each in (*found.related, *found.chain)), *found.hidden)
    return any(span.path == name for span in places) or Path(name).name in found.message


def test_a_failure_on_one_source_costs_that_source(plant: Plant, tmp_path: Path) -> None:
    tree = tmp_path / "robot"
    shutil.copytree(TREE, tree, symlinks=True)
    before = checked(tree)
    assert before.failures == ()
    robot = Robot(discover((str(tree),), root=str(tree)))
    chance = random.Random(1)
    targets = [(function, name) for function, names in sorted(plant.seen.items()) for name in sorted(names - {""})]
    lost: dict[tuple[str, str], set[Any]] = {}
    for function, name in chance.sample(targets, SAMPLE):
        plant.function, plant.source = function, name
        after = checked(tree)
        told = [found for found in after.findings if found.rule == INTERNAL_ERROR]
        there = set(map(mark, after.findings))
        plant.function = ""
        without = set(map(mark, run(robot.without([name]), Registry.of(), Config(min_severity="info")).findings))
        expected = without & {mark(found) for found in before.findings if not concerns(found, name)}
        if expected - there:
            lost[function, name] = expected - there
        if not any(found.span.path == name for found in told):
            lost[function, name] = {("no word", *map(mark, told))}
    assert lost == {}
