"""XML and YAML launch files against launch's own front ends: the same files are refused."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

from bringup_lint.graph.launch.grammar import refusals
from bringup_lint.parsers import launch_xml
from bringup_lint.parsers import launch_yaml
from bringup_lint.source import Source
from tests.oracles.answers import Oracle
from tests.oracles.launch_mutations import variants
from tests.oracles.ros_python import PYTHON
from tests.oracles.ros_python import tool

FOLDER = Path(__file__).parent / "launch_grammar"
VARIANTS = 450
"""Of each file."""
DISTRIBUTION = "jazzy"
"""The one whose launch gave the record."""


def questions() -> list[list[str]]:
    found = []
    for seed, form in enumerate(("xml", "yaml")):
        name = f"all.launch.{form}"
        text = (FOLDER / name).read_text("utf-8")
        found += [[name, text], *([name, each] for each in variants(text, form, VARIANTS, seed))]
    return found


def reference(asked: list[list[str]]) -> list[str | None]:
    environment = {key: value for key, value in os.environ.items() if key != "PYTHONPATH"} | {"PYTHONHASHSEED": "0"}
    command = [PYTHON, str(Path(__file__).parent / "launch_grammar_runner.py")]
    run = subprocess.run(command, input=json.dumps(asked), capture_output=True, text=True, env=environment, check=False)
    assert run.returncode == 0, run.stderr
    return json.loads(run.stdout)


def refused(name: str, text: str) -> bool:
    parse = launch_xml.parse if name.endswith(".xml") else launch_yaml.parse
    file = parse(Source(name, text))
    return bool(file.problems or refusals(file, DISTRIBUTION))


def test_refused_as_by_launch(answers: Oracle) -> None:
    given = answers.of("launch/grammar", tool(), questions(), reference)
    rejected = [(question, error) for question, error in given.pairs if error]
    missed = [(question, error) for question, error in rejected if not refused(*question)]
    wrong = [question for question, error in given.pairs if not error and refused(*question)]
    assert len(rejected) > VARIANTS
    assert wrong == []
    assert len(missed) <= len(rejected) // 100, missed[0]
