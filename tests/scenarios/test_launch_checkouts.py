"""Over checkouts of real ROS 2 repositories, named by BRINGUP_LINT_CHECKOUTS: nothing fails, and most nodes are
understood."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import understood
from bringup_lint.robot import Robot

pytestmark = pytest.mark.corpus

CHECKOUTS = Path(os.environ.get("BRINGUP_LINT_CHECKOUTS", "/nonexistent"))
WANTED = ("navigation2", "turtlebot4_robot", "linorobot2", "autoware_launch")


def source_resolved(value: Value) -> bool:
    """An inline dictionary with known names, a file by its place, or an argument that the user must pass."""
    while isinstance(value, (ParameterFile, DerivedFile)):
        value = value.file if isinstance(value, ParameterFile) else value.base
    if isinstance(value, DictValue):
        return not value.open and all(understood(name) for name, _ in value.items)
    if isinstance(value, Choice):
        return all(source_resolved(option) for _, option in value.options)
    return place(value) is not None or (isinstance(value, Argument) and value.default is None)


def resolved(node: Started) -> bool:
    program = node.executable or node.plugin
    names = [value for value in (node.package, program, node.name) if value is not None]
    return all(text_of(name) is not None or isinstance(name, Argument) for name in names) and all(
        map(source_resolved, node.parameters)
    )


@pytest.mark.parametrize("repository", sorted(path.name for path in CHECKOUTS.glob("*")) or ["none"])
def test_most_nodes_are_understood(repository: str, monkeypatch: pytest.MonkeyPatch) -> None:
    if not CHECKOUTS.is_dir():
        pytest.skip("BRINGUP_LINT_CHECKOUTS is not set")
    monkeypatch.chdir(CHECKOUTS / repository)
    robot = Robot(discover(["."]))
    nodes = [node for expansion in robot.launch.expansions for node in expansion.nodes if node.is_node]
    assert robot.failures == []
    share = sum(map(resolved, nodes)) / len(nodes) if nodes else 1.0
    print(f"{repository}: {len(robot.launch.launch_files)} launch files, {len(nodes)} nodes, {share:.1%} resolved")
    if repository in WANTED:
        assert share >= 0.9
