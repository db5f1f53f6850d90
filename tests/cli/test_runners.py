"""What files and their names say is no command of the CI runner that reads the output, and drives no terminal."""

from __future__ import annotations

import json
import re
import subprocess
from pathlib import Path

import pytest

from bringup_lint.report import FORMATS
from bringup_lint.report.columns import laid_out
from bringup_lint.report.columns import printable
from bringup_lint.report.unicode import harmless
from tests.lint import lint

COMMAND = re.compile(r"##(?:vso)?\[|^\s*::(?!:)", re.M | re.I)
"""GitHub's runner and Azure's agent look for the first anywhere in a line, for the second at its start."""
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028-\u202e]")
NAMES = (
    "##[add-mask]a.service",
    "##vso[task.setvariable variable=a]b.service",
    "::error::c.service",
    "d\x1b[2J\x9b.service",
)
UNIT = (
    "[Unit]\nAfter=network.target ##VSO[task.complete result=Failed]\n[Service]\n# ##[stop-commands]x\n"
    "ExecStart=/usr/bin/ros2 launch a b.launch.py\nRestart=##[add-matcher]m\n"
)


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    folder = tmp_path / "tree"
    folder.mkdir()
    for number, name in enumerate(NAMES):
        (folder / name).write_text(f"# {number}\n{UNIT}")
    return folder


def quiet(text: str) -> bool:
    return not COMMAND.search(text) and not CONTROL.search(text)


@pytest.mark.parametrize("output_format", sorted({*FORMATS} - {"github"}))
def test_reports(tree: Path, output_format: str) -> None:
    run = lint("--output-format", output_format, "--min-severity", "info", cwd=tree)
    assert run.code == 1 and run.stdout
    assert quiet(run.stdout) and quiet(run.stderr)


def test_github_has_only_its_own_commands(tree: Path) -> None:
    run = lint("--output-format", "github", "--min-severity", "info", cwd=tree)
    assert run.stdout and all(re.match(r"::(?:error|warning|notice) ", line) for line in run.stdout.splitlines())
    assert not re.search(r"##(?:vso)?\[", run.stdout, re.I)


@pytest.mark.parametrize("arguments", [["--statistics"], ["--show-files"], ["--show-settings"], ["init"]])
def test_other_texts(tree: Path, arguments: list[str]) -> None:
    assert quiet(lint(*arguments, cwd=tree).stdout)


@pytest.mark.slow
@pytest.mark.parametrize("output_format", ["text", "concise", "json", "html", "sarif"])
def test_fleets(tree: Path, output_format: str) -> None:
    assert quiet(lint("fleet", "--output-format", output_format, "--workers", "1", ".", cwd=tree).stdout)


def test_the_picture_as_data(tree: Path) -> None:
    assert quiet(lint("graph", "--format", "json", cwd=tree).stdout)


def test_data_stays_what_it_is(tree: Path) -> None:
    findings = json.loads(lint("--output-format", "json", cwd=tree).stdout)["findings"]
    assert {each["location"]["path"] for each in findings} == {*NAMES}
    assert json.loads(harmless(json.dumps({"##[a]": "\x9b\u2028##vso[é"}, ensure_ascii=False))) == {
        "##[a]": "\x9b\u2028##vso[é"
    }


def test_a_bracket_keeps_its_width() -> None:
    for text in ("##[x]", "a ##vso[b]", "## [x]", "é##[x]"):
        assert len(printable(text)) == len(text)
        assert laid_out(text).cells[-1] == len(text)
    assert printable("# [x] ## a [0]") == "# [x] ## a [0]"


def test_no_name_ends_the_header_of_a_diff(tmp_path: Path) -> None:
    (tmp_path / "a\n+++ b\r.service").write_text("[Service]\nExecStart=/bin/a\nKillMode=Process")
    (tmp_path / 'é "b".service').write_text("[Unit]\nStartLimitInterval=200\n[Service]\nExecStart=/bin/a \\")
    said = lint("--diff", "--unsafe-fixes", cwd=tmp_path).stdout
    heads = [line for line in said.split("\n") if line.startswith(("--- ", "+++ "))]
    assert len(heads) % 2 == 0 and heads
    assert not any(line == "+++ b" or "\r" in line for line in heads)
    assert '+++ "é \\"b\\".service"' in heads


def patched(folder: Path, patch: str) -> None:
    subprocess.run(["git", "apply", "-p0", "-"], cwd=folder, input=patch.encode(), check=True)


LINES = ("[Unit]", "Description=a", "[Service]", "ExecStart=/bin/a", "TimeoutStopSec=9", "StandardOutput=syslog", "")
COMMANDS = (
    "::error::x",
    "  ::error::x",
    "\v::stop-commands::x",
    "##[add-mask]x",
    "# a ##vso[task.x]",
)


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize(("at", "is_shown"), [(1, True), (4, True), (5, False)])
def test_a_diff_is_a_patch_without_a_command(tmp_path: Path, command: str, at: int, is_shown: bool) -> None:
    """What is next to the change is always shown, and with it what is a command there."""
    unit = tmp_path / "a.service"
    unit.write_bytes("\n".join((*LINES[:at], command, *LINES[at:])).encode())
    run = lint("--diff", "--select", "systemd/legacy-key", cwd=tmp_path)
    assert (run.code, bool(run.stdout), "Not shown: " in run.stderr) == (int(is_shown), is_shown, not is_shown)
    assert not COMMAND.search(run.stdout)
    if is_shown:
        patched(tmp_path, run.stdout)
        assert b"StandardOutput=journal\n" in unit.read_bytes()


def test_a_name_in_the_header_of_a_diff_is_no_command(tmp_path: Path) -> None:
    unit = tmp_path / "##[add-mask]a.service"
    unit.write_text("\n".join(LINES))
    run = lint("--diff", "--select", "systemd/legacy-key", cwd=tmp_path)
    assert run.stdout and quiet(run.stdout)
    patched(tmp_path, run.stdout)
    assert "StandardOutput=journal" in unit.read_text()
