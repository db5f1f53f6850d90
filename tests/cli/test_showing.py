"""What a run shows beside findings: settings, files, statistics, and how far it is."""

from __future__ import annotations

import contextlib
import io
import time
from pathlib import Path

import pytest

from bringup_lint.cli import progress
from tests.lint import lint

UNIT = "[Unit]\nDescription=One\n[Service]\nExecStart=/bin/true\nRestartSec=soon\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    (tmp_path / "test").mkdir()
    (tmp_path / "a.service").write_text(UNIT)
    (tmp_path / "test/b.service").write_text(UNIT.replace("soon", "never"))
    return tmp_path


def test_show_files(tree: Path) -> None:
    (tree / "notes.txt").touch()
    run = lint("--show-files", cwd=tree)
    assert run == (0, "a.service       systemd-unit\ntest/b.service  systemd-unit, test\n", "")
    assert lint("--show-files", "--exclude", "test/", cwd=tree).stdout == "a.service  systemd-unit\n"


def test_show_settings(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('exclude = ["x/"]\nmin-severity = "info"\n\n[severity]\n"node" = "off"\n')
    said = lint("--show-settings", "--exclude", "y/", "--fail-on", "error", cwd=tree).stdout.splitlines()
    told = [tuple(part.strip() for part in line.split("  # ")) for line in said]
    assert ('exclude = ["x/", "y/"]', f"{tree}/bringup-lint.toml:1, command line") in told
    assert ('min-severity = "info"', f"{tree}/bringup-lint.toml:2") in told
    assert ('severity."node" = "off"', f"{tree}/bringup-lint.toml:5") in told
    assert ('fail-on = "error"', "command line") in told
    assert ("select = []", "default") in told
    assert ('target-ros = ""', "not known") in told


def test_settings_of_a_tree_that_names_its_distribution(tree: Path) -> None:
    (tree / "Dockerfile").write_text("FROM ros:jazzy\n")
    lines = {line.partition(" ")[0]: line for line in lint("--show-settings", cwd=tree).stdout.splitlines()}
    assert lines["target-ros"].endswith("# named in Dockerfile")
    assert lines["target-systemd"].startswith("target-systemd = 255 ")


def test_settings_are_valid_toml_that_says_the_same(tree: Path) -> None:
    from bringup_lint.toml import read_toml

    (tree / "bringup-lint.toml").write_text('[severity]\n"systemd/root-user" = "error"\n[purpose]\n"test/" = "ci"\n')
    data = read_toml(lint("--show-settings", cwd=tree).stdout)
    assert data["severity"] == {"systemd/root-user": "error"}
    assert data["purpose"] == {"test/": "ci"}


def test_statistics(tree: Path) -> None:
    (tree / "test/b.service").rename(tree / "b.service")
    run = lint("--statistics", "--select", "systemd/invalid-value", cwd=tree)
    assert run.code == 1
    assert run.stdout == (
        "findings  severity  fixable  rule\n       2  error              systemd/invalid-value\n\n2 errors in 2 files\n"
    )


def test_quiet(tree: Path) -> None:
    (tree / "test/b.service").rename(tree / "b.service")
    loud = lint("--select", "systemd/invalid-value", cwd=tree).stdout
    quiet = lint("--quiet", "--select", "systemd/invalid-value", cwd=tree)
    assert loud == f"{quiet.stdout}\n2 errors in 2 files\n"
    assert lint("--quiet", "--select", "netplan", cwd=tree) == (0, "", "")
    assert lint("--quiet", "--statistics", cwd=tree).code == 2


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> Terminal:
    monkeypatch.setattr(progress, "PATIENCE", 0.01)
    monkeypatch.setattr(progress, "PERIOD", 0.01)
    monkeypatch.setenv("TERM", "xterm")
    return Terminal()


def waited(terminal: Terminal, wanted: bool = True) -> str:
    with contextlib.redirect_stderr(terminal), progress.progress(wanted) as state:
        state.rule()
        time.sleep(0.2)
    return terminal.getvalue()


def test_progress_is_taken_away(terminal: Terminal) -> None:
    shown = waited(terminal)
    assert "\rbringup-lint: rule 1 (0 s)\x1b[K" in shown
    assert shown.endswith("\r\x1b[K")


def test_no_progress_where_nobody_looks(terminal: Terminal, monkeypatch: pytest.MonkeyPatch) -> None:
    assert waited(terminal, wanted=False) == ""
    monkeypatch.setenv("TERM", "dumb")
    assert waited(terminal) == ""
    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(terminal, "isatty", lambda: False)
    assert waited(terminal) == ""


def test_a_short_run_shows_no_progress(terminal: Terminal, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(progress, "PATIENCE", 60)
    assert waited(terminal) == ""
