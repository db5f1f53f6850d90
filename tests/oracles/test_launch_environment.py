"""The environment of every process that ROS's own launch starts, against ours."""

from __future__ import annotations

import json
import os
import random
import subprocess
from itertools import count
from pathlib import Path

import pytest

from bringup_lint.discover.walk import discover
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.environment.launched import launched
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.robot import Robot
from bringup_lint.source import Source
from tests.oracles.answers import Oracle
from tests.oracles.ros_python import PYTHON
from tests.oracles.ros_python import tool

HERE = Path(__file__).parent
BASE = {"BASE": "here", "LIST": "/a", "ROS_DOMAIN_ID": "1"}
"""What the launch process itself has."""
NAMES = (*BASE, "ONE", "TWO")
OF_SHELL = ("PWD", "OLDPWD", "SHLVL", "_", "PYTHONUNBUFFERED", "OVERRIDE_LAUNCH_PROCESS_OUTPUT")
MADE = 60
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


def real(files: list[Path]) -> list[dict[str, dict[str, str]]]:
    """File by file, a process to its variables, without those that the launch process got from the machine."""
    keep = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", *NAMES)}
    flags = {"FLAG0": "true", "FLAG1": "false"}
    environment = {"AMENT_PREFIX_PATH": str(Path(PYTHON).parent.parent), **keep, **BASE, **flags}
    command = [PYTHON, str(HERE / "launch_environment_runner.py"), *map(str, files)]
    run = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert run.returncode == 0, run.stderr
    found = json.loads(run.stdout.splitlines()[-1])
    assert not [path for path, run in found.items() if run["code"] != 0]
    machine = {key for key in {**environment, **dict.fromkeys(OF_SHELL)} if key not in NAMES}
    return [
        {
            process: {name: value for name, value in sorted(values.items()) if name not in machine}
            for process, values in sorted(found[str(path)]["processes"].items())
        }
        for path in files
    ]


def ours(files: list[Path]) -> dict[str, dict[str, Environment]]:
    """File -> process -> environment, when the launch process has ``BASE`` and nothing else that matters."""
    base = Environment()
    place = Source("shell").located(0, 0)
    for name, value in BASE.items():
        base.set(Variable(name, place, value, "shell"))
    launch = Robot(discover([str(files[0].parent)])).launch
    found = {}
    for path in files:
        (file,) = [file for file in launch.launch_files if Path(file.source.name).name == path.name]
        processes = launched(launch.expansion(file), base)
        found[str(path)] = {process_name(each.node): each.environment for each in processes}
    return found


def process_name(node) -> str:
    """The file that the process writes to: the last word of its command line."""
    return text_of(node.arguments[-1]).rpartition(" ")[2].strip("'")


def differences(pairs: list[tuple[Path, dict[str, dict[str, str]]]]) -> tuple[int, int, list]:
    """How many values were compared, how many of them we do not know, and those that differ."""
    found = ours([path for path, _ in pairs])
    compared = unknown = 0
    wrong = []
    for path, processes in pairs:
        assert processes.keys() == found[str(path)].keys(), path
        for process, values in processes.items():
            environment = found[str(path)][process]
            for name in {*NAMES, *(name for chains in found[str(path)].values() for name in chains.chains)}:
                compared += 1
                said = environment.text(name)
                if name in environment and said is None:
                    unknown += 1
                elif said != values.get(name):
                    wrong.append((path.name, process, name, said, values.get(name)))
    return compared, unknown, wrong


def test_every_way_to_change_it(answers: Oracle) -> None:
    folder = HERE / "launch_environment"
    names = sorted(path.name for path in folder.glob("*.launch.*"))
    given = answers.of("launch/actions", tool(), names, lambda names: real([folder / name for name in names]))
    compared, unknown, wrong = differences([(folder / name, processes) for name, processes in given.pairs])
    assert wrong == []
    assert unknown == 0
    assert compared > 100


def random_description(chance: random.Random, unsure: bool = False) -> str:
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


def written(folder: Path, texts: list[str]) -> list[Path]:
    folder.mkdir()
    files = [folder / f"random{number:02}.launch.py" for number in range(len(texts))]
    for path, text in zip(files, texts, strict=True):
        path.write_text(text, "utf-8")
    return files


@pytest.mark.parametrize(("unsure", "share"), [(False, 0.01), (True, 0.4)], ids=["sure", "unsure"])
def test_random_descriptions(unsure: bool, share: float, answers: Oracle, tmp_path: Path) -> None:
    chance = random.Random(11)
    texts = [random_description(chance, unsure).replace("'FLAG'", f"'FLAG{number % 2}'") for number in range(MADE)]
    record = "launch/unsure" if unsure else "launch/sure"
    given = answers.of(record, tool(), texts, lambda texts: real(written(tmp_path / "real", texts)))
    files = written(tmp_path / "ours", [text for text, _ in given.pairs])
    compared, unknown, wrong = differences(list(zip(files, (answer for _, answer in given.pairs), strict=True)))
    print(f"{compared} values compared, {unknown} not known to us")
    assert wrong == []
    assert unknown <= compared * share
    assert compared > 1000
