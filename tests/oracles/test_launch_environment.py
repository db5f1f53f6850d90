"""The environment of every process that ROS's own launch starts, against ours: needs an interpreter with launch.

Its path is taken from BRINGUP_LINT_ROS_PYTHON; without it, or when it lacks the packages, the tests are skipped.
"""

from __future__ import annotations

import json
import os
import random
import subprocess
from itertools import count
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.environment.launching import launched
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.systemd.environment import Environment
from bringup_lint.graph.systemd.environment import Variable
from bringup_lint.robot import Robot
from bringup_lint.source import Source

HERE = Path(__file__).parent
PYTHON = os.environ.get("BRINGUP_LINT_ROS_PYTHON", "")
BASE = {"BASE": "here", "LIST": "/a", "ROS_DOMAIN_ID": "1"}
"""What the launch process itself has."""
NAMES = (*BASE, "ONE", "TWO")
BRED = 60
HEAD = """from launch import LaunchDescription
from launch.actions import AppendEnvironmentVariable, ExecuteProcess, GroupAction, PopEnvironment, PushEnvironment
from launch.actions import ResetEnvironment, SetEnvironmentVariable, TimerAction, UnsetEnvironmentVariable
from launch.conditions import IfCondition
from launch.substitutions import EnvironmentVariable


def probe(name, **options):
    return ExecuteProcess(cmd=['/bin/sh', '-c', 'env > "$0"', name], **options)


def generate_launch_description():
    return LaunchDescription([
"""


def real(files: list[Path]) -> dict[str, dict]:
    if not PYTHON:
        pytest.skip("BRINGUP_LINT_ROS_PYTHON is not set")
    keep = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", *NAMES)}
    flags = {"FLAG0": "true", "FLAG1": "false"}
    environment = {"AMENT_PREFIX_PATH": str(Path(PYTHON).parent.parent), **keep, **BASE, **flags}
    command = [PYTHON, str(HERE / "launch_environment_runner.py"), *map(str, files)]
    run = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    if run.returncode != 0 and "ModuleNotFoundError" in run.stderr:
        pytest.skip(run.stderr.splitlines()[-1])
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout.splitlines()[-1])


def ours(files: list[Path]) -> dict[str, dict[str, Environment]]:
    """File -> process -> environment, when the launch process has ``BASE`` and nothing else that matters."""
    base = Environment()
    place = Source("shell").located(0, 0)
    for name, value in BASE.items():
        base.set(Variable(name, place, value, "shell"))
    launch = Robot(discover([str(files[0].parent)])).launch
    found = {}
    for path in files:
        (file,) = [file for file in launch.files if Path(file.source.name).name == path.name]
        processes = launched(launch.expansion(file), base)
        found[str(path)] = {process_name(each.node): each.environment for each in processes}
    return found


def process_name(node) -> str:
    """The file that the process writes to: the last word of its command line."""
    return text_of(node.arguments[-1]).rpartition(" ")[2].strip("'")


def differences(files: list[Path]) -> tuple[int, int, list]:
    """How many values were compared, how many of them we do not know, and those that differ."""
    expected, found = real(files), ours(files)
    compared = unknown = 0
    wrong = []
    for path, run in expected.items():
        assert run["code"] == 0, path
        assert run["processes"].keys() == found[path].keys(), path
        for process, values in run["processes"].items():
            environment = found[path][process]
            for name in {*NAMES, *(name for chains in found[path].values() for name in chains.chains)}:
                compared += 1
                said = environment.text(name)
                if name in environment and said is None:
                    unknown += 1
                elif said != values.get(name):
                    wrong.append((Path(path).name, process, name, said, values.get(name)))
    return compared, unknown, wrong


def test_every_way_to_change_it() -> None:
    files = sorted((HERE / "launch_environment").glob("*.launch.*"))
    compared, unknown, wrong = differences(files)
    assert wrong == []
    assert unknown == 0
    assert compared > 100


def bred(chance: random.Random, unsure: bool = False) -> str:
    """``unsure``: some changes depend on a variable that only the real launch knows."""
    maybe = ", condition=IfCondition(EnvironmentVariable('FLAG'))" if unsure else ""
    numbers = count()

    def value() -> str:
        name = chance.choice(NAMES)
        return chance.choice([f"'{chance.randint(0, 9)}'", f"[EnvironmentVariable('{name}', default_value='d'), 'x']"])

    def action(depth: int) -> str:
        name = chance.choice(NAMES)
        deeper = ", ".join(action(depth + 1) for _ in range(chance.randint(1, 4))) if depth < 2 else ""
        inner = deeper or f"probe('p{next(numbers)}')"
        when = chance.choice(["", "", ", condition=IfCondition('true')", ", condition=IfCondition('false')"])
        change = chance.choice([when, maybe])
        return chance.choice([
            f"probe('p{next(numbers)}')",
            f"probe('p{next(numbers)}', additional_env={{'{name}': {value()}}})",
            f"probe('p{next(numbers)}', env={{'{name}': {value()}}})",
            f"SetEnvironmentVariable('{name}', {value()}{change})",
            f"SetEnvironmentVariable('{name}', {value()})",
            f"AppendEnvironmentVariable('{name}', {value()}, prepend={chance.choice(['True', 'False'])}{change})",
            f"UnsetEnvironmentVariable('{name}'{change})",
            f"GroupAction([{inner}], scoped={chance.choice(['True', 'True', 'False'])}{when})",
            f"GroupAction([{inner}], forwarding=False)",
            f"GroupAction([SetEnvironmentVariable('{name}', {value()})], scoped=False{change})",
            f"PushEnvironment(), ResetEnvironment(), {inner}, PopEnvironment()",
            f"TimerAction(period=0.05, actions=[probe('p{next(numbers)}')])",
        ])  # fmt: skip

    body = ",\n        ".join(action(0) for _ in range(12))
    return f"{HEAD}        {body},\n        probe('end'),\n    ])\n"


@pytest.mark.parametrize(("unsure", "share"), [(False, 0.01), (True, 0.4)], ids=["sure", "unsure"])
def test_bred_descriptions(unsure: bool, share: float, tmp_path: Path) -> None:
    chance = random.Random(11)
    files = [tmp_path / f"bred{number:02}.launch.py" for number in range(BRED)]
    for number, path in enumerate(files):
        path.write_text(bred(chance, unsure).replace("'FLAG'", f"'FLAG{number % 2}'"))
    compared, unknown, wrong = differences(files)
    print(f"{compared} values compared, {unknown} not known to us")
    assert wrong == []
    assert unknown <= compared * share
    assert compared > 1000
