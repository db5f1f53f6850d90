"""Node lists against ROS's own launch: the same nodes from the same files."""

from __future__ import annotations

import json
import os
import subprocess
from functools import cache
from pathlib import Path

from bringup_lint.discover.walk import discover
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import EventHandler
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.model.launch_values import Value
from bringup_lint.robot import Robot
from tests.oracles.answers import Oracle
from tests.oracles.ros_python import PYTHON
from tests.oracles.ros_python import tool

FOLDER = Path(__file__).parent / "launch_files"
PACKAGE = FOLDER / "demo_robot"
FILES = sorted(path for path in (PACKAGE / "launch").iterdir() if path.name[0] in "abc" and path.name[1].isdigit())


@cache
def robot() -> Robot:
    return Robot(discover([str(FOLDER)]))


def reference(names: list[str], prefix: Path) -> list[list[dict]]:
    """What ROS's launch starts, for every file."""
    index = prefix / "share" / "ament_index" / "resource_index" / "packages"
    index.mkdir(parents=True)
    (index / PACKAGE.name).touch()
    (prefix / "share" / PACKAGE.name).symlink_to(PACKAGE)
    runner = Path(__file__).parent / "launch_runner.py"
    files = [str(PACKAGE / "launch" / name) for name in names]
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
    command = [PYTHON, str(runner), str(prefix), *files]
    run = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert run.returncode == 0, run.stderr
    text = run.stdout.replace(str(prefix / "share" / PACKAGE.name), "SHARE").replace(str(PACKAGE), "SHARE")
    found = json.loads(text)
    assert not [each["error"] for each in found.values() if "error" in each]
    return [found[file.replace(str(PACKAGE), "SHARE")]["nodes"] for file in files]


def path_text(value: Value) -> str | None:
    found = place(value.file if isinstance(value, ParameterFile) else value)
    if found is None:
        return None
    path = found.path.replace(str(PACKAGE), "SHARE")
    return f"SHARE/{path}" if found.base == "share" else path


def plain(value: Value):
    """A parameter's value as launch_ros evaluates it."""
    if isinstance(value, TypedValue):
        return plain(value.value) if value.type != "str" else text_of(value.value)
    if isinstance(value, ListValue):
        return [plain(item) for item in value.items]
    if isinstance(value, Literal):
        return value.value if not isinstance(value.value, str) else str(value.value)
    return repr(type(value))


def flat(values: DictValue, prefix: str = "") -> dict:
    result = {}
    for key, value in values.items:
        name = f"{prefix}{text_of(key)}"
        if isinstance(value, DictValue):
            result.update(flat(value, f"{name}."))
        else:
            result[name] = plain(value)
    return result


def described(node: Started) -> dict:
    return {
        "package": text_of(node.package) if node.package else None,
        "program": text_of(node.executable or node.plugin) if node.executable or node.plugin else None,
        "name": text_of(node.name) if node.name else None,
        "namespace": node.namespace,
        "remappings": [[text_of(src), text_of(dst)] for src, dst in node.remappings],
        "parameters": [
            flat(source) if isinstance(source, DictValue) else path_text(source)
            for source in node.parameters[len(node.parameters) - len(node.action.parameters) :]
        ]
        if hasattr(node.action, "parameters")
        else [],
    }


def loose(value):
    """launch_ros gives YAML of texts; numbers and truth values compare by their text."""
    if isinstance(value, list):
        return [loose(item) for item in value]
    if isinstance(value, dict):
        return {key: loose(item) for key, item in value.items()}
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (int, float)):
        return f"{value:g}"
    return (
        os.path.normpath(value)
        if isinstance(value, str) and value.startswith("SHARE")
        else str(value).lower().strip("'\"\n")
    )


def started(name: str) -> list[dict]:
    """What we say that a file starts."""
    launch = robot().launch
    (file,) = [file for file in launch.launch_files if Path(file.source.name).name == name]
    return [
        described(node)
        for node in launch.expansion(file).nodes
        if node.by_default and node.is_node and not any(isinstance(around, EventHandler) for around in node.context)
    ]


def test_same_nodes_as_launch(answers: Oracle, tmp_path: Path) -> None:
    names = [path.name for path in FILES]
    given = answers.of("launch/nodes", tool(), names, lambda names: reference(names, tmp_path / "prefix"))
    assert len(given.pairs) == len(FILES)
    for name, nodes in given.pairs:
        assert loose(started(name)) == loose(nodes), name
