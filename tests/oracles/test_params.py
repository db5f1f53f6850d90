"""rcl's own parser: the same files accepted, the same names, types and values, for every case.

The real one needs ``pip install 'ros-jazzy-rclpy[fastrtps]'``. Its library gives its whole table, which is quick enough
for thousands of files; some of them are also given to real nodes with ``--params-file``.
"""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from bringup_lint.model.params import NOT_SET
from bringup_lint.model.params import ParameterFile
from bringup_lint.model.params import Value
from bringup_lint.parsers.params import parse
from bringup_lint.source import Source
from bringup_lint.toml import read_toml
from tests.oracles.answers import Oracle
from tests.oracles.ros_python import rclpy

FOLDER = Path(__file__).parent
WORDS = read_toml((FOLDER / "params.toml").read_text("utf-8"))
DIFFERENCES = {
    each["file"]: each["reason"]
    for each in read_toml((FOLDER / "differences/params.toml").read_text("utf-8"))["difference"]
}
CORPUS = os.environ.get("BRINGUP_LINT_CORPUS", "")
BRED = 3000
STARTED = 120
"""Bred files that are also given to a real node."""
OWN = ("use_sim_time", "start_type_description_service")
"""Parameters that every rclpy node declares for itself."""


def ask(cases: list[dict]) -> list:
    """What the real parser makes of the cases, in a process of its own: a damaged file may bring it down."""
    run = subprocess.run(
        [sys.executable, FOLDER / "rcl_params.py"],
        input=json.dumps(cases),
        capture_output=True,
        text=True,
        timeout=300,
        env={**os.environ, "ROS_AUTOMATIC_DISCOVERY_RANGE": "OFF"},
    )
    assert run.returncode == 0, run.stderr[-2000:]
    return json.loads(run.stdout)


def read(text: str) -> ParameterFile:
    return parse(Source("params.yaml", text))


def shown(value: Value | None) -> list:
    if value is None:
        return [NOT_SET, None]
    data = value.data
    shape = [_number(each) for each in data] if isinstance(data, list) else _number(data)
    return [value.type, shape]


def _number(data: object) -> object:
    return repr(data) if isinstance(data, float) else data


def table(text: str) -> dict | None:
    file = read(text)
    if not file.accepted:
        return None
    return {node: [[entry.name, *shown(entry.value)] for entry in entries] for node, entries in file.nodes.items()}


def node(text: str, name: str, namespace: str) -> dict | str:
    file = read(text)
    if not file.accepted:
        return "refused"
    found = {key: shown(value) for key, value in file.of_node(f"{namespace.rstrip('/')}/{name}").items()}
    if any(type_ == NOT_SET for type_, _ in found.values()):
        return "not set"
    return found


def breed(chance: random.Random) -> str:
    """A parameter file of the words in ``params.toml``, the odd ones rarer."""

    def word(kind: str) -> str:
        return chance.choice(WORDS[kind] if chance.random() < 0.75 else WORDS[f"odd_{kind}"])

    def parameters(indent: int, depth: int) -> str:
        lines = ""
        for _ in range(chance.randint(0 if depth else 1, 4)):
            if depth < 2 and chance.random() < 0.2:
                lines += f"{' ' * indent}{word('names')}:\n{parameters(indent + 2, depth + 1)}"
            else:
                lines += f"{' ' * indent}{word('names')}: {word('values')}\n"
        return lines

    def nodes(indent: int, depth: int) -> str:
        lines = ""
        for _ in range(chance.randint(1, 3)):
            lines += f"{' ' * indent}{word('nodes')}:"
            what = chance.random()
            if what < 0.15 and depth < 2:
                lines += f"\n{nodes(indent + 2, depth + 1)}"
            elif what < 0.97:
                lines += f"\n{' ' * (indent + 2)}ros__parameters:\n{parameters(indent + 4, 0)}"
                lines += nodes(indent + 2, depth + 1) if chance.random() < 0.05 else ""
            else:
                lines += f" {word('values')}\n"
        return lines

    return nodes(0, 0) + (f"---\n{nodes(0, 0)}" if chance.random() < 0.1 else "")


@cache
def generated() -> list[str]:
    chance = random.Random(7)
    return [breed(chance) for _ in range(BRED)]


def scalars() -> list[str]:
    """Every value by itself, and at the end of a list."""
    words = [*WORDS["values"], *WORDS["odd_values"]]
    files = [f"n:\n  ros__parameters:\n    a: {value}\n" for value in words]
    return files + [f"n:\n  ros__parameters:\n    a: [{value}, {value}]\n" for value in words if "\n" not in value]


def keys() -> list[str]:
    return [
        f"{key}:\n  ros__parameters:\n    a: 1\nx:\n  {key}:\n    ros__parameters:\n      b: 2\n"
        for key in (*WORDS["nodes"], *WORDS["odd_nodes"])
    ]


def real_files() -> list[str]:
    files = sorted({*Path(CORPUS).rglob("*.yaml"), *Path(CORPUS).rglob("*.yml")})
    texts = (path.read_text("utf-8", "replace") for path in files if path.is_file())
    return [text for text in texts if "ros__parameters" in text and "\0" not in text]


def judge_tables(pairs: list[tuple[str, dict | None]]) -> None:
    wrong = [(text, real) for text, real in pairs if (table(text) != real) is not (text in DIFFERENCES)]
    assert not wrong, (
        f"{len(wrong)} of {len(pairs)}, the first:\n{wrong[0][0]}\nreal: {wrong[0][1]}\nours: {table(wrong[0][0])}"
    )


def tables(texts: list[str]) -> list:
    return ask([{"text": text} for text in texts])


def test_every_file_gives_the_same_table(answers: Oracle) -> None:
    texts = [*WORDS["files"], *scalars(), *keys(), *generated()]
    given = answers.of("rcl/tables", rclpy(), texts, tables)
    judge_tables(given.pairs)
    assert sum(answer is not None for _, answer in given.pairs) > len(given.pairs) // 5


@pytest.mark.corpus
@pytest.mark.skipif(rclpy() == "rclpy", reason="needs rclpy")
@pytest.mark.skipif(not CORPUS, reason="BRINGUP_LINT_CORPUS names no folder")
def test_real_files_give_the_same_table() -> None:
    texts = real_files()
    judge_tables(list(zip(texts, tables(texts), strict=True)))


def arrived(cases: list[list[str]]) -> list[dict | str]:
    """Text, name and namespace to the parameters that a real node gets, without those that it declares for itself."""
    return [_own(found) for found in ask([{"text": text, "node": [name, space]} for text, name, space in cases])]


def test_real_nodes_get_what_we_say(answers: Oracle) -> None:
    chance = random.Random(11)
    names = [("n", "/"), ("n", "/x"), ("m", "/x/y")]
    files = [*WORDS["files"], *keys(), *scalars(), *(text for text in generated() if table(text))][: 330 + STARTED]
    cases = [[text, *chance.choice(names)] for text in files]
    pairs = answers.of("rcl/nodes", rclpy(), cases, arrived).pairs
    assert len(pairs) >= 400
    wrong = [(case, real) for case, real in pairs if case[0] not in DIFFERENCES and _own(node(*case)) != real]
    assert not wrong, (
        f"{len(wrong)} of {len(cases)}, the first:\n{wrong[0][0]}\nreal: {wrong[0][1]}\nours: {node(*wrong[0][0])}"
    )


def _own(found: dict | str) -> dict | str:
    return {key: value for key, value in found.items() if key not in OWN} if isinstance(found, dict) else found
