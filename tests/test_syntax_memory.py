"""The syntax of nodes is read once, and dies when the last rule that asks for it has run."""

from __future__ import annotations

import ast
import gc
import sys
from pathlib import Path

import pytest

from bringup_lint.config import Config
from bringup_lint.discover.walk import discover
from bringup_lint.engine import run
from bringup_lint.parsers import python_node
from bringup_lint.registry import Registry
from bringup_lint.report.order import at_boot
from bringup_lint.robot import Robot
from bringup_lint.rule_index.described import described

BENCHMARKS = Path(__file__).parents[1] / "benchmarks"


@pytest.fixture
def generated(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    monkeypatch.delitem(sys.modules, "robot", raising=False)
    import robot as robots

    return robots.generate(tmp_path / "robot", 3)


def _trees() -> set[int]:
    return {id(each) for each in gc.get_objects() if isinstance(each, ast.Module)}


def test_trees_die_with_the_last_rule_that_asks(generated: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[str] = []
    read_module = python_node.read_module

    def counted(tree: ast.Module) -> python_node.Module:
        read.append("")
        return read_module(tree)

    monkeypatch.setattr(python_node, "read_module", counted)
    robot = Robot(discover([str(generated)]))
    registry = Registry.of()
    run(robot, registry, Config())
    gc.collect()
    before = _trees()
    robot = Robot(discover([str(generated)]))
    read.clear()
    gc.disable()
    try:
        run(robot, registry, Config())
        left = _trees() - before
    finally:
        gc.enable()
    at_boot(robot.graph)
    assert len(read) == 3
    assert not left


def test_what_is_asked_later_is_made_again(generated: Path) -> None:
    robot = Robot(discover([str(generated)]))
    before = [(node.name, [str(each.name) for each in node.endpoints]) for node in robot.nodes.classes]
    robot.let_go_of_syntax()
    assert [(node.name, [str(each.name) for each in node.endpoints]) for node in robot.nodes.classes] == before
    assert all(file.tree is not None for file in robot.nodes)


def test_index_knows_what_a_rule_asks_for() -> None:
    path = Registry.of().paths["params/not-declared"]
    assert "topics" in described(path.read_text("utf-8")).asks
