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
from bringup_lint.finding.copies import REPEATED
from bringup_lint.registry import Registry
from bringup_lint.source import Source
from tests.lint import lint
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import case_id
from tests.rules.test_fixtures import cases
from tests.rules.test_fixtures import command
from tests.rules.test_fixtures import set_modes
from tests.sample import sampled
from tests.suppress.placing import problems

JSON = ("--output-format", "json", "--min-severity", "info")
REVEALED = {
    "cyclonedds/invalid-value": {
        "cyclonedds/no-multicast-no-peers": "the file is read, and multicast is off, as it says",
        "cyclonedds/no-multicast-participantindex-none": "the file is read, and multicast is off, as it says",
    },
    "fastdds/bool-case": {"fastdds/no-transport": "the file is read, and the built-in transports are off, as it says"},
    "launch/ros1-construct": {"launch/ros1-construct": "the next word of ROS 1 in the file comes to light"},
    "udev/syntax": {"udev/duplicate-symlink": "the rule is read, and makes the link of another one"},
}
"""Rules whose fix lets the reader go on, to the errors that were hidden before, each with its reason."""
FIXING = {rule.id for rule in Registry.of().all() if rule.meta.fix != "none" and rule.family != "live"}
FIXES = [case for case in cases("bad") if case[0] in FIXING]


def findings(rule_id: str, folder: Path) -> list[dict[str, Any]]:
    family = rule_id.partition("/")[0]
    run = lint(*command(rule_id), "--select", family, *JSON, *arguments(folder), cwd=folder)
    assert run.code in (0, 1), run.stderr
    return json.loads(run.stdout)["findings"]


def errors(found: list[dict[str, Any]]) -> Counter[tuple[str, str]]:
    return Counter((each["rule"], each["location"]["path"]) for each in found if each["severity"] == "error")


def messages(rule_id: str, found: list[dict[str, Any]]) -> Counter[str]:
    """What a rule says, as often as it says it, in places of its own or in those of one finding."""
    said: Counter[str] = Counter()
    for each in found:
        if each["rule"] == rule_id:
            said[each["message"]] += 1 + sum(place["message"] == REPEATED for place in each["related"])
    return said


def texts(folder: Path) -> dict[str, bytes]:
    files = (path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def source(name: str, data: bytes) -> Source:
    text = data.decode("utf-8", "replace")
    return Source(name, text, kind_of(name, lambda: text[:HEAD_SIZE]))


@pytest.mark.parametrize(("rule_id", "case"), sampled(FIXES, 10, pytest.mark.slow), ids=case_id)
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
    revealed = REVEALED.get(rule_id, {})
    assert {rule for rule, _ in errors(after) - errors(before)} <= set(revealed)
    assert messages(rule_id, before) - messages(rule_id, after)
    assert rule_id in revealed or messages(rule_id, after).total() < messages(rule_id, before).total()
    for name in (name for name in new if new[name] != old.get(name)):
        assert set(problems(source(name, new[name]), new[name].decode())) <= set(
            problems(source(name, old[name]), old[name].decode())
        )
        assert new[name].count(b"\r\n") == (new[name].count(b"\n") if b"\r\n" in old[name] else 0)
    lint(*fix, cwd=folder)
    assert texts(folder) == new


@pytest.mark.slow
@pytest.mark.parametrize("rule_id", REVEALED)
def test_what_fixes_reveal_is_still_so(rule_id: str, tmp_path: Path) -> None:
    new: set[str] = set()
    for number, case in enumerate(case for each, case in FIXES if each == rule_id):
        folder = shutil.copytree(case, tmp_path / str(number), symlinks=True)
        before = findings(rule_id, folder)
        lint("--fix", "--unsafe-fixes", "--select", rule_id, *arguments(folder), cwd=folder)
        after = findings(rule_id, folder)
        new |= {rule for rule, _ in errors(after) - errors(before)}
        new |= {rule_id} if messages(rule_id, after) - messages(rule_id, before) else set()
    assert new == set(REVEALED[rule_id])


@pytest.mark.parametrize(("rule_id", "case"), sampled(FIXES, 10, pytest.mark.slow), ids=case_id)
def test_fix_keeps_crlf(rule_id: str, case: Path, tmp_path: Path) -> None:
    folder = shutil.copytree(case, tmp_path / "tree", symlinks=True)
    for path in [path for path in folder.rglob("*") if path.is_file() and not path.is_symlink()]:
        if path.name not in ("arguments.txt", "modes.txt") and b"\n" in path.read_bytes():
            path.write_bytes(path.read_bytes().replace(b"\r\n", b"\n").replace(b"\n", b"\r\n"))
    lint("--fix", "--unsafe-fixes", "--select", rule_id, *arguments(folder), cwd=folder)
    mixed = [name for name, data in texts(folder).items() if 0 < data.count(b"\r\n") < data.count(b"\n")]
    assert [name for name in mixed if name not in ("arguments.txt", "modes.txt")] == []
