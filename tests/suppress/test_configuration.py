"""``[per-file-ignores]`` and severities of the configuration."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.lint import lint
from tests.test_engine import own_rule

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


SWITCHED_OFF = [
    'ignore = ["systemd/network-target"]\n',
    'ignore = ["systemd"]\n',
    '[severity]\n"systemd/network-target" = "off"\n',
    '[severity]\n"systemd" = "off"\n',
]


@pytest.mark.parametrize("text", SWITCHED_OFF)
def test_what_a_found_configuration_switches_off_is_counted(tree: Path, text: str) -> None:
    (tree / "bringup-lint.toml").write_text(text)
    asked = ("--select", "systemd/network-target")
    assert "2 suppressed by bringup-lint.toml: --no-ignores" in lint(*asked, cwd=tree).stdout
    assert "2 suppressed by bringup-lint.toml" in lint(*asked, "--output-format", "markdown", cwd=tree).stdout
    summary = json.loads(lint(*asked, "--output-format", "json", cwd=tree).stdout)["summary"]
    assert (summary["warning"], summary["suppressed_by"]) == (0, {"bringup-lint.toml": 2})
    results = json.loads(lint(*asked, "--output-format", "sarif", cwd=tree).stdout)["runs"][0]["results"]
    assert {each["suppressions"][0]["kind"] for each in results} == {"external"}
    assert lint(*asked, "--output-format", "junit", cwd=tree).stdout.count("<skipped") == 2
    assert (lint(*asked, cwd=tree).code, lint(*asked, "--no-ignores", cwd=tree).code) == (0, 1)


def test_a_finding_names_the_entry_that_switches_it_off(tree: Path) -> None:
    text = '[severity]\nsystemd = "info"\n"systemd/network-target" = "off"\n'
    (tree / "bringup-lint.toml").write_text(text)
    sarif = lint("--select", "systemd/network-target", "--output-format", "sarif", cwd=tree).stdout
    results = json.loads(sarif)["runs"][0]["results"]
    reasons = [each["justification"] for result in results for each in result["suppressions"]]
    assert reasons == ["'systemd/network-target' is switched off in bringup-lint.toml"] * 2


@pytest.mark.parametrize("text", SWITCHED_OFF)
def test_what_the_user_switches_off_does_not_run(tree: Path, text: str) -> None:
    (tree / "bringup-lint.toml").write_text(text)
    for arguments in (("--config", "bringup-lint.toml"), ("--ignore", "systemd")):
        run = lint("--select", "systemd/network-target", "--output-format", "json", *arguments, cwd=tree)
        assert json.loads(run.stdout)["findings"] == []


def test_a_rule_that_fails_can_be_switched_off(tree: Path) -> None:
    own_rule(tree, body="raise KeyError(word)")
    (tree / "own/own.service").write_text("[Service]\nExecStart=/bin/legacy\n")
    (tree / "bringup-lint.toml").write_text('ignore = ["site/no-legacy"]\n')
    asked = ("--rules", "own", "--select", "site/no-legacy")
    assert lint(*asked, "--isolated", cwd=tree).code == 3
    run = lint(*asked, cwd=tree)
    assert (run.code, "suppressed" in run.stdout, run.stderr) == (0, False, "")


def test_what_a_found_configuration_leaves_out_is_said(tree: Path) -> None:
    text = 'select = ["systemd"]\nexclude = ["older/"]\n[purpose]\n"own/" = "archive"\n'
    (tree / "bringup-lint.toml").write_text(text)
    said = lint(cwd=tree).stdout
    assert "1 path excluded by bringup-lint.toml" in said
    assert "rules not selected by bringup-lint.toml" in said
    assert "purpose of 1 path set by bringup-lint.toml" in said
    assert "bringup-lint.toml" not in lint("--config", "bringup-lint.toml", cwd=tree).stdout
    narrowed = json.loads(lint("--output-format", "json", cwd=tree).stdout)["summary"]["narrowed"]
    assert len(narrowed) == 3
    run = json.loads(lint("--output-format", "sarif", cwd=tree).stdout)["runs"][0]
    assert run["properties"]["narrowed"] == narrowed


def test_the_summary_says_what_silences(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('ignore = ["systemd/network-target"]\n')
    (tree / "own/own.service").write_text(f"# bringup-lint: ignore-file[systemd/root-user]: known\n{UNIT}")
    said = lint(cwd=tree).stdout
    assert "1 suppressed by comments, 2 suppressed by bringup-lint.toml: --no-ignores" in said


def test_a_comment_that_names_no_rule_of_a_family_is_reported(tmp_path: Path) -> None:
    names = ("systemd/rot-user", "site/own-rule", "udev/syntax")
    comments = "".join(f"# bringup-lint: ignore[{name}]: known\n" for name in names)
    (tmp_path / "a.service").write_text(comments + UNIT)
    for arguments in ((), ("--select", "systemd,lint")):
        said = lint("--output-format", "concise", *arguments, cwd=tmp_path).stdout.splitlines()
        unused = [line for line in said if "lint/unused-ignore" in line]
        assert [line.partition("] ")[2] for line in unused] == ["ignore[systemd/rot-user] silences nothing here"]
