"""Exit codes and reports when a stream, a variable, the locale or the working folder is broken."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.lint import lint

pytestmark = pytest.mark.slow
UNIT = "[Unit]\nDescription=One Å – 2\nAfter=network.target\n[Service]\nExecStart=/usr/bin/ros2 launch a b.launch.py\n"
COMMAND = f"{sys.executable} -m bringup_lint --select systemd/network-target"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    (tmp_path / "a.service").write_text(UNIT)
    return tmp_path


def shell(line: str, cwd: Path, **environment: str) -> subprocess.CompletedProcess[bytes]:
    variables = {**os.environ, "PYTHONPATH": str(PROJECT), **environment}
    return subprocess.run(["sh", "-c", line], cwd=cwd, capture_output=True, env=variables, timeout=120)


@pytest.mark.parametrize(
    ("line", "environment", "code"),
    [
        (f"{COMMAND} >&-", {}, 2),
        (f"{COMMAND} > /dev/full", {}, 2),
        (f"{COMMAND} --stdin-filename a.service <&-", {}, 2),
        (f"{sys.executable} -m bringup_lint server <&-", {}, 2),
        (f"mkdir gone && cd gone && rmdir ../gone && {COMMAND}", {}, 2),
        (COMMAND, {"COLUMNS": "²"}, 1),
        (COMMAND, {"COLUMNS": "9" * 5000}, 1),
        (f"{COMMAND} --output-format sarif", {"SOURCE_DATE_EPOCH": "99999999999999"}, 1),
        (COMMAND, {"PYTHONIOENCODING": "ascii"}, 1),
        (f"{COMMAND} --output-format json", {"PYTHONIOENCODING": "ascii"}, 1),
        (COMMAND, {"PYTHONIOENCODING": "latin-1"}, 1),
        (COMMAND, {"LC_ALL": "C", "PYTHONCOERCECLOCALE": "0", "PYTHONUTF8": "0"}, 1),
        (COMMAND, {"PYTHONOPTIMIZE": "2"}, 1),
        (f"{COMMAND} 2>&-", {}, 1),
    ],
)
def test_the_exit_code_is_one_of_the_documented_ones(
    tree: Path, line: str, environment: dict[str, str], code: int
) -> None:
    run = shell(line, tree, **environment)
    assert run.returncode == code, run.stderr
    assert b"Traceback" not in run.stderr
    assert b"Exception ignored" not in run.stderr
    if code == 1:
        assert b"systemd/network-target" in run.stdout


COMMANDS = [
    "rules",
    "explain systemd/root-user",
    "--help",
    "--version",
    "init --help",
    "graph .",
    "rules --help",
    "fleet .",
]


@pytest.mark.parametrize("command", COMMANDS)
def test_a_full_disk_is_said_in_a_line(tree: Path, command: str) -> None:
    run = shell(f"{sys.executable} -m bringup_lint {command} > /dev/full", tree)
    assert (run.returncode, run.stdout) == (2, b"")
    assert run.stderr == b"bringup-lint: standard output: No space left on device\n"


@pytest.mark.parametrize("command", COMMANDS)
def test_nobody_has_to_read_on(tree: Path, command: str) -> None:
    read, write = os.pipe()
    os.close(read)
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}
    whole = [sys.executable, "-m", "bringup_lint", *command.split()]
    run = subprocess.run(whole, cwd=tree, stdout=write, stderr=subprocess.PIPE, env=environment, timeout=120)
    os.close(write)
    assert run.returncode in (0, 1)
    assert run.stderr == b""


@pytest.mark.parametrize("command", COMMANDS)
def test_a_closed_output_is_no_bug(tree: Path, command: str) -> None:
    run = shell(f"{sys.executable} -m bringup_lint {command} >&-", tree)
    assert run.returncode in (0, 1, 2)
    assert b"internal error" not in run.stderr
    assert b"Traceback" not in run.stderr


def test_an_interrupt_is_130(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint import engine

    def interrupted(*arguments: object, **named: object) -> None:
        signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(engine, "run", interrupted)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        assert lint("a.service", cwd=tree).code == 130
    finally:
        signal.signal(signal.SIGINT, before)


def test_what_nothing_isolates_is_one_line(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint import engine

    def broken(*arguments: object, **named: object) -> None:
        raise KeyError("secret")

    monkeypatch.setattr(engine, "run", broken)
    run = lint("a.service", cwd=tree)
    assert (run.code, run.stdout) == (3, "")
    assert (
        run.stderr == "bringup-lint: internal error: KeyError; BRINGUP_LINT_TRACEBACK=1 shows where, please report it\n"
    )


def test_no_file_drives_the_terminal(tree: Path) -> None:
    (tree / "bringup-lint.toml").write_text('select = ["a\\u001b]0;PWNED\\u0007"]\n')
    run = lint(cwd=tree)
    assert run.code == 2
    assert "\x1b" not in run.stderr
    assert "\x07" not in run.stderr


def test_no_file_name_is_a_command_of_a_runner(tree: Path) -> None:
    (tree / "::set-output name=x::y.service").write_text(UNIT.replace("One", "Two"))
    run = lint("--output-format", "concise", "--select", "systemd/network-target", ".", cwd=tree)
    assert "./::set-output" in run.stdout
    assert not any(line.startswith("::") for line in run.stdout.splitlines())
