"""Fixed launch files against launch's own front ends: none is refused that was accepted before.

What launch says is recorded; ``BRINGUP_LINT_ROS_PYTHON`` names an interpreter that has it.
"""

from __future__ import annotations

import shutil
import tempfile
from functools import cache
from pathlib import Path

from tests.lint import lint
from tests.oracles.answers import Oracle
from tests.oracles.ros_python import tool
from tests.oracles.test_launch_grammar import reference
from tests.rules.test_fixes import FIXES
from tests.rules.test_fixes import source
from tests.rules.test_fixes import texts
from tests.rules.test_fixtures import arguments

LAUNCH = frozenset({"launch-python", "launch-xml", "launch-yaml"})
RULES = ("launch/", "params/", "topic/", "tf/", "lifecycle/", "env/")


@cache
def fixed() -> list[tuple[str, str, str]]:
    """The names of launch files that fixes change, with their texts before and after."""
    found = []
    for rule_id, case in FIXES:
        if not rule_id.startswith(RULES):
            continue
        with tempfile.TemporaryDirectory() as place:
            folder = shutil.copytree(case, Path(place, "tree"), symlinks=True)
            old = texts(folder)
            fix = ("--fix", "--unsafe-fixes", "--min-severity", "info", "--select", rule_id)
            lint(*fix, *arguments(folder), cwd=folder)
            for name, data in texts(folder).items():
                if data != old.get(name) and source(name, data).kind in LAUNCH:
                    found.append((Path(name).name, old[name].decode(), data.decode()))
    return found


def test_no_fixed_file_is_refused_that_was_accepted(answers: Oracle) -> None:
    questions = list({(name, text): None for name, *pair in fixed() for text in pair})
    given = answers.of("launch/fixes", tool(), [list(each) for each in questions], reference)
    said = {(name, text): error for (name, text), error in given.pairs}
    judged = [
        (name, said[name, old], said[name, new], new)
        for name, old, new in fixed()
        if {(name, old), (name, new)} <= said.keys()
    ]
    assert len(judged) > len(fixed()) // 2
    assert [(name, after, new) for name, before, after, new in judged if after and not before] == []
