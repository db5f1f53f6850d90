"""The files that MoveItConfigsBuilder opens while a launch file is evaluated, and that its package does not have."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.workspace import Place
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.parsers.yaml_nodes import parse as parse_yaml

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.workspace import Package
    from bringup_lint.source import Source
    from bringup_lint.source import Span

_BUILDER = "MoveItConfigsBuilder"
_OPENED = {
    "robot_description_semantic": "",
    "robot_description_kinematics": "config/kinematics.yaml",
    "joint_limits": "config/joint_limits.yaml",
    "moveit_cpp": "config/moveit_cpp.yaml",
    "pilz_cartesian_limits": "config/pilz_cartesian_limits.yaml",
    "trajectory_execution": "",
}
"""Method -> the file that it opens where it is given none. Source: moveit_configs_utils, moveit_configs_builder.py."""
_ALWAYS = ("robot_description_semantic", "robot_description_kinematics", "joint_limits")
"""What ``to_moveit_configs`` opens where the chain of calls does not."""
_ASSISTANT = ".setup_assistant"
_DEPTH = 60


class MissingMoveItFile(NamedTuple):
    path: str
    """In the package."""
    package: Package
    where: Span
    exists: bool
    """In the source, but no rule installs it."""


def missing_moveit_files(launch: Launch, tree: Tree) -> Iterator[list[MissingMoveItFile]]:
    """Those of one chain of calls together."""
    for file in launch.judged:
        source = file.source
        module = tree_of(source) if file.format == "python" and _BUILDER in source.text else None
        if module is None:
            continue
        positions = Positions(source, byte_order_mark(source))
        inner: set[int] = set()
        for node in ast.walk(module):
            if isinstance(node, ast.Call) and id(node) not in inner:
                calls = _chain(node)
                inner.update(id(each) for each in calls)
                found = list(_of_chain(launch, tree, positions, calls)) if calls else []
                if found:
                    yield found


def _chain(node: ast.expr) -> list[ast.Call]:
    """The calls of methods, each on the result of the one before, of which the first makes the builder."""
    calls: list[ast.Call] = []
    while isinstance(node, ast.Call) and len(calls) < _DEPTH:
        calls.append(node)
        if isinstance(node.func, ast.Name) and node.func.id == _BUILDER:
            return calls[::-1]
        if not isinstance(node.func, ast.Attribute):
            break
        node = node.func.value
    return []


def _of_chain(launch: Launch, tree: Tree, positions: Positions, calls: list[ast.Call]) -> Iterator[MissingMoveItFile]:
    made, *methods = calls
    model, named = _text(_argument(made, "robot_name", 0)), _argument(made, "package_name", 2)
    name = _text(named) if named is not None else f"{model}_moveit_config"
    package = launch.workspace.packages.get(name or "")
    if model is None or package is None:
        return
    called = {call.func.attr: call for call in methods if isinstance(call.func, ast.Attribute)}
    opened: list[tuple[str | None, ast.expr]] = []
    for method, call in called.items():
        if method in _OPENED:
            given = _argument(call, "file_path", 0)
            default = _semantic(tree, package, model) if method == "robot_description_semantic" else _OPENED[method]
            opened.append((_text(given) if given is not None else default, call if given is None else given))
    if "to_moveit_configs" in called:
        for method in _ALWAYS:
            if method not in called:
                path = _OPENED[method] or _semantic(tree, package, model)
                opened.append((path, made))
    for path, node in opened:
        found = launch.workspace.find(Place("share", package.name, path)) if path and path[0] not in "/." else None
        if path and found is not None and (found.file is None or found.installed is False):
            yield MissingMoveItFile(path, package, positions.span(node), found.file is not None)


def _argument(call: ast.Call, name: str, at: int) -> ast.expr | None:
    given = next((each.value for each in call.keywords if each.arg == name), None)
    if given is None and at < len(call.args):
        return call.args[at]
    return given


def _text(node: ast.expr | None) -> str | None:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _semantic(tree: Tree, package: Package, model: str) -> str | None:
    """The SRDF that the builder opens by itself: that of the setup assistant, or the one with the robot's name."""
    path = f"{package.folder}/{_ASSISTANT}"
    source = tree.at(path) if tree.is_file(path) else None
    if source is None:
        return f"config/{model}.srdf"
    return _assistant_srdf(source) or f"config/{model}.srdf"


def _assistant_srdf(source: Source) -> str | None:
    documents = parse_yaml(source).documents
    root = documents[0].root if documents else None
    config = root.mapping("moveit_setup_assistant_config") if isinstance(root, Mapping) else None
    semantic = (config.mapping("srdf") or config.mapping("SRDF")) if config is not None else None
    path = semantic.scalar("relative_path") if semantic is not None else None
    return str(path.value) if path is not None else None
