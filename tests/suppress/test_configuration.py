"""``[per-file-ignores]`` and severities of the configuration."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.lint import lint

UNIT = "[Unit]\nAfter=network.target\n[Service]\nExecStart=/usr/bin/ros2 launch a b.launch.py\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    for folder in ("older", "own"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / f"{folder}.service").write_text(UNIT)
    return tmp_path


def rules(tree: Path, configuration: str, *arguments: str) -> set[tuple[str, str]]:
    """(rule, path) of what is reported."""
    (tree / "bringup-lint.toml").write_text(configuration)
    run = lint("--output-format", "json", *arguments, cwd=tree)
    assert run.code in (0, 1), run.stderr
    findings = json.loads(run.stdout)["findings"]
    return {(each["rule"], each["location"]["path"]) for each in findings if not each["suppressed"]}


def test_files_without_a_rule(tree: Path) -> None:
    every = rules(tree, "")
    left = rules(tree, '[per-file-ignores]\n"older/" = ["systemd/root-user"]\n')
    assert every - left == {("systemd/root-user", "older/older.service")}


def test_files_without_a_family(tree: Path) -> None:
    left = rules(tree, '[per-file-ignores]\n"/older/*.service" = ["systemd"]\n')
    assert {path for rule, path in left if rule.startswith("systemd")} == {"own/own.service"}


def test_entries_are_relative_to_their_file(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('[per-file-ignores]\n"/older/" = ["systemd", "env"]\n')
    assert lint("--output-format", "concise", ".", cwd=tree / "older").stdout == ""


def test_no_ignores_shows_them(tree: Path) -> None:
    every = rules(tree, "")
    assert rules(tree, '[per-file-ignores]\n"*" = ["systemd"]\n', "--no-ignores") == every


def test_sarif_says_that_the_configuration_silences(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('[per-file-ignores]\n"*" = ["systemd"]\n')
    run = lint("--output-format", "sarif", "--select", "systemd/network-target", cwd=tree)
    (suppression,) = json.loads(run.stdout)["runs"][0]["results"][0]["suppressions"]
    assert suppression["kind"] == "external"
    assert suppression["location"]["physicalLocation"]["region"]["startLine"] == 2


def complaints(tree: Path, *arguments: str) -> str:
    return lint("--select", "lint,systemd", "--output-format", "concise", *arguments, cwd=tree).stdout


def test_pattern_that_matches_no_file_is_reported(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('[per-file-ignores]\n"gone/" = ["systemd"]\n')
    assert "bringup-lint.toml:2:2: warning[lint/unused-ignore] The pattern 'gone/' matches no file" in complaints(tree)


def test_rule_that_finds_nothing_is_reported(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('[per-file-ignores]\n"older/" = ["systemd/kill-mode", "udev"]\n')
    text = complaints(tree)
    assert "udev has nothing to silence" not in text, "udev was not selected"
    assert "systemd/kill-mode has nothing to silence in 'older/'" in text


def test_part_of_the_tree_proves_nothing(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('[per-file-ignores]\n"gone/" = ["systemd"]\n')
    assert "unused-ignore" not in complaints(tree, "own")


def test_unknown_name_is_an_error(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('[per-file-ignores]\n"own/" = ["systemd/network-targt"]\n')
    run = lint(cwd=tree)
    assert run.code == 2
    assert "did you mean 'systemd/network-target'?" in run.stderr


def test_severity_of_a_family(tree: Path) -> None:
    text = '[severity]\nsystemd = "info"\n"systemd/network-target" = "error"\n'
    assert {rule for rule, _ in rules(tree, text) if rule.startswith("systemd")} == {"systemd/network-target"}


def test_rule_that_is_off(tree: Path) -> None:
    assert "systemd/network-target" in {rule for rule, _ in rules(tree, "")}
    off = rules(tree, '[severity]\n"systemd/network-target" = "off"\n')
    assert "systemd/network-target" not in {rule for rule, _ in off}


def test_family_that_is_off(tree: Path) -> None:
    text = '[severity]\nsystemd = "off"\n"systemd/network-target" = "warning"\n'
    assert {rule for rule, _ in rules(tree, text) if rule.startswith("systemd")} == {"systemd/network-target"}
