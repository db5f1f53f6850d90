"""Every fix of every bad fixture: the finding is gone, the file is valid, nothing new appears, nothing else changes."""

from __future__ import annotations

import json
import shutil
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from bringup_lint.discover.kinds import HEAD_SIZE
from bringup_lint.discover.kinds import kind_of
from bringup_lint.registry import Registry
from bringup_lint.source import Source
from tests.lint import lint
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import case_id
from tests.rules.test_fixtures import cases
from tests.rules.test_fixtures import command
from tests.rules.test_fixtures import set_modes
from tests.suppress.placing import problems

EVERY = 10
"""Of so many fixtures, one is tried in a quick run; all of them in a whole one."""
JSON = ("--output-format", "json", "--min-severity", "info")
REVEALED = {
    "cyclonedds/invalid-value": "the file is read, and what it sets comes into effect",
    "fastdds/bool-case": "the file is read, and what it sets comes into effect",
    "fastdds/unknown-element": "the element has its name, and is there twice",
    "launch/package-missing": "the package has its name, and its executables are looked for",
    "launch/ros1-construct": "the next word of ROS 1 in the file comes to light",
    "udev/syntax": "the rule is read, and makes the link of another one",
}
"""Rules whose fix lets the reader go on, to what was hidden before."""
FIXING = {rule.id for rule in Registry.of().all() if rule.meta.fix != "none" and rule.family != "live"}
FIXES = [case for case in cases("bad") if case[0] in FIXING]


def tried() -> list[object]:
    marks = [() if number % EVERY == 0 else (pytest.mark.slow,) for number in range(len(FIXES))]
    return [pytest.param(*case, marks=mark) for case, mark in zip(FIXES, marks)]


def findings(rule_id: str, folder: Path) -> list[dict[str, Any]]:
    family = rule_id.partition("/")[0]
    run = lint(*command(rule_id), "--select", family, *JSON, *arguments(folder), cwd=folder)
    assert run.code in (0, 1), run.stderr
    return json.loads(run.stdout)["findings"]


def errors(found: list[dict[str, Any]]) -> Counter[tuple[str, str]]:
    return Counter((each["rule"], each["location"]["path"]) for each in found if each["severity"] == "error")


def texts(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def source(name: str, data: bytes) -> Source:
    text = data.decode("utf-8", "replace")
    return Source(name, text, kind_of(name, lambda: text[:HEAD_SIZE]))


@pytest.mark.parametrize(("rule_id", "case"), tried(), ids=case_id)
def test_fix(rule_id: str, case: Path, tmp_path: Path) -> None:
    set_modes(case)
    folder = shutil.copytree(case, tmp_path / "tree", symlinks=True)
    before, old = findings(rule_id, folder), texts(folder)
    fixable = sum(each["rule"] == rule_id and each["fix"] is not None for each in before)
    fix = ("--fix", "--unsafe-fixes", "--select", rule_id, "--output-format", "concise", *arguments(folder))
    lint(*fix, cwd=folder)
    after, new = findings(rule_id, folder), texts(folder)
    if not fixable:
        assert new == old
        return
    if rule_id not in REVEALED:
        assert sum(each["rule"] == rule_id for each in after) < sum(each["rule"] == rule_id for each in before)
        assert errors(after) - errors(before) == Counter()
    for name in (name for name in new if new[name] != old.get(name)):
        assert set(problems(source(name, new[name]), new[name].decode())) <= set(
            problems(source(name, old[name]), old[name].decode())
        )
        assert new[name].count(b"\r\n") == (new[name].count(b"\n") if b"\r\n" in old[name] else 0)
    lint(*fix, cwd=folder)
    assert texts(folder) == new


@pytest.mark.parametrize(("rule_id", "case"), tried(), ids=case_id)
def test_fix_keeps_crlf(rule_id: str, case: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(case, tmp_path / "tree", symlinks=True)
    for path in [path for path in folder.rglob("*") if path.is_file() and not path.is_symlink()]:
        if path.name not in ("arguments.txt", "modes.txt") and b"\n" in path.read_bytes():
            path.write_bytes(path.read_bytes().replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"))
    lint("--fix", "--unsafe-fixes", "--select", rule_id, *arguments(folder), cwd=folder)
    mixed = [name for name, data in texts(folder).items() if 0 < data.count(b"\r\n") < data.count(b"\n")]
    assert [name for name in mixed if name not in ("arguments.txt", "modes.txt")] == []
