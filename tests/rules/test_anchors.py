"""Fixes of YAML keep anchors, and are unsafe where an alias repeats what they change."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from tests.lint import lint
from tests.rules.test_fixes import FIXES
from tests.rules.test_fixtures import arguments
from tests.rules.test_fixtures import case_id
from tests.sample import sampled

FAMILIES = ("compose", "launch", "netplan", "params")
_VALUE = re.compile(r"^(\s+(?:- )?[\w.-]+: +)(?=[^\s#&*!|>{\[?-])", re.M)
_ANCHOR = re.compile(r"&a\d+ ")


def files(folder: Path) -> list[Path]:
    return [path for path in sorted(folder.rglob("*.yaml")) if path.is_file() and not path.is_symlink()]


OF_YAML = [case for case in FIXES if case[0].partition("/")[0] in FAMILIES and files(case[1])]


def with_anchors(text: str) -> str:
    """The text with an anchor at each scalar of a mapping."""
    count = 0

    def anchored(match: re.Match[str]) -> str:
        nonlocal count
        count += 1
        return f"{match[1]}&a{count} "

    return _VALUE.sub(anchored, text)


def fixed(rule_id: str, folder: Path) -> dict[str, str]:
    lint("--fix", "--unsafe-fixes", "--min-severity", "info", "--select", rule_id, *arguments(folder), cwd=folder)
    return {str(path.relative_to(folder)): path.read_text("utf-8") for path in files(folder)}


@pytest.mark.parametrize(("rule_id", "case"), sampled(OF_YAML, 10, pytest.mark.slow), ids=case_id)
def test_a_fix_keeps_anchors(rule_id: str, case: Path, tmp_path: Path) -> None:
    plain = shutil.copytree(case, tmp_path / "plain" / "tree", symlinks=True)
    anchored = shutil.copytree(case, tmp_path / "anchored" / "tree", symlinks=True)
    before = {}
    for path in files(anchored):
        path.write_text(with_anchors(path.read_text("utf-8")), "utf-8")
        before[str(path.relative_to(anchored))] = path.read_text("utf-8")
    without, kept = fixed(rule_id, plain), fixed(rule_id, anchored)
    for name, text in kept.items():
        assert text == before[name] or _ANCHOR.sub("", text) == without[name]
        assert text == before[name] or _ANCHOR.findall(text) == _ANCHOR.findall(before[name])


COMPOSE = "services:\n  driver:\n    image: a\n    user: {}{}\n    cpu_shares: {}\n"


@pytest.mark.parametrize(("anchor", "other", "safe"), [("&r ", "*r", False), ("&r ", "2", True), ("", "2", True)])
def test_a_fix_of_what_an_alias_repeats_is_unsafe(tmp_path: Path, anchor: str, other: str, safe: bool) -> None:
    path = tmp_path / "compose.yaml"
    path.write_text(COMPOSE.format(anchor, "1000", other))
    options = ("--select", "compose/invalid-value", "--output-format", "json", ".")
    found = json.loads(lint(*options, cwd=tmp_path).stdout)["findings"]
    assert {each["fix"]["applicability"] for each in found} == {"safe" if safe else "unsafe"}
    lint("--fix", *options, cwd=tmp_path)
    assert (" 1000\n" in path.read_text()) == (not safe)
    lint("--fix", "--unsafe-fixes", *options, cwd=tmp_path)
    assert path.read_text() == COMPOSE.format(anchor, '"1000"', other)


def test_a_fix_beside_what_an_alias_repeats_is_safe(tmp_path: Path) -> None:
    (tmp_path / "compose.yaml").write_text(COMPOSE.format("", "1000", "2") + "x-a: &a 1\nx-b: *a\n")
    found = json.loads(lint("--output-format", "json", ".", cwd=tmp_path).stdout)["findings"]
    (each,) = (each for each in found if each["rule"] == "compose/invalid-value")
    assert each["fix"]["applicability"] == "safe"


def test_a_file_of_yaml_may_have_any_name(tmp_path: Path) -> None:
    text = "version: 2\nrenderer: {}networkmanager\nethernets:\n  eth0:\n    renderer: {}\n"
    (tmp_path / "network-config").write_text(text.format("&r ", "*r"))
    run = lint("--select", "netplan", "--output-format", "json", ".", cwd=tmp_path)
    fixes = [each["fix"] for each in json.loads(run.stdout)["findings"] if each["fix"]]
    assert {each["applicability"] for each in fixes} == {"unsafe"}
