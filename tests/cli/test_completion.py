"""Completion as the real shells do it, where they are installed."""

from __future__ import annotations

import os
import pty
import select
import shutil
import subprocess
import time
from pathlib import Path

import pytest

from bringup_lint.cli.syntax import commands
from tests.lint import lint

ASKED = [
    ("bringup-lint explain systemd/root", {"systemd/root-needed", "systemd/root-user"}),
    ("bringup-lint --select netplan/default-r", {"netplan/default-route-conflict"}),
    ("bringup-lint --select lint,netplan/default-r", {"lint,netplan/default-route-conflict"}),
    ("bringup-lint check --target-ros j", {"jazzy"}),
    ("bringup-lint graph --fo", {"--focus", "--format"}),
    ("bringup-lint rules netp", {"netplan"}),
    ("bringup-lint comp", {"completion"}),
    ("bringup-lint completion f", {"fish"}),
    ("bringup-lint ot", {"otter.service"}),
]
"""A line, and what it may become at its end."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "otter.service").touch()
    return tmp_path


@pytest.fixture(scope="module")
def scripts(tmp_path_factory: pytest.TempPathFactory) -> Path:
    top = tmp_path_factory.mktemp("completion")
    for shell in ("bash", "zsh", "fish"):
        run = lint("completion", shell, cwd=top)
        assert (run.code, run.stderr) == (0, "")
        (top / shell).write_text(run.stdout)
    return top


def real(shell: str) -> str:
    path = shutil.which(shell)
    if path is None:
        pytest.skip(f"{shell} is not installed")
    return path


def said(*words: str, cwd: Path) -> list[str]:
    run = subprocess.run(words, capture_output=True, text=True, cwd=cwd, check=True, timeout=60)
    assert run.stderr == ""
    return run.stdout.splitlines()


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_scripts_are_valid(shell: str, scripts: Path) -> None:
    assert said(real(shell), "-n", str(scripts / shell), cwd=scripts) == []


@pytest.mark.slow
@pytest.mark.parametrize(("line", "expected"), [*ASKED, ("bringup-lint --select=netplan/default-r", set())])
def test_bash(line: str, expected: set[str], scripts: Path, folder: Path) -> None:
    words = line.replace("=", " = ").split()
    program = 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _bringup_lint; printf "%s\\n" "${COMPREPLY[@]}"'
    expected = expected or {"netplan/default-route-conflict"}
    assert set(said(real("bash"), "-c", program, str(scripts / "bash"), *words, cwd=folder)) == expected


@pytest.mark.slow
@pytest.mark.parametrize(
    ("line", "expected"),
    [*ASKED, ("bringup-lint --select=netplan/default-r", {"--select=netplan/default-route-conflict"})],
)
def test_fish(line: str, expected: set[str], scripts: Path, folder: Path) -> None:
    program = f"source {scripts / 'fish'}; complete -C '{line}'"
    answers = said(real("fish"), "--no-config", "-c", program, cwd=folder)
    assert {answer.partition("\t")[0] for answer in answers} == expected


@pytest.mark.slow
@pytest.mark.parametrize(
    ("line", "expected"),
    [*ASKED, ("bringup-lint --select=netplan/default-r", {"netplan/default-route-conflict"})],
)
def test_zsh(line: str, expected: set[str], scripts: Path, folder: Path) -> None:
    """The line in a terminal after the Tab key: the one completion is in it, several are listed below."""
    program = real("zsh")
    shell, terminal = pty.fork()
    if shell == 0:
        os.chdir(folder)
        os.environ.update(TERM="dumb", PS1="", ZDOTDIR=str(folder))
        os.execv(program, ["zsh", "-f", "-i"])
    try:
        start = f"PS1='' PS2=''; autoload -Uz compinit; compinit -u -D; source {scripts / 'zsh'}; print rea''dy\n"
        os.write(terminal, start.encode())
        assert b"ready" in _read(terminal, b"ready")
        os.write(terminal, f"{line}\t\t".encode())
        words = [each.rpartition(",")[2].encode() for each in expected]
        shown = _read(terminal, *words)
        assert all(word in shown for word in words), shown.decode(errors="replace")
    finally:
        os.close(terminal)
        os.waitpid(shell, 0)


def _read(terminal: int, *until: bytes) -> bytes:
    shown, end = b"", time.monotonic() + 30
    while not all(word in shown for word in until) and time.monotonic() < end:
        if select.select([terminal], [], [], 0.2)[0]:
            shown += os.read(terminal, 65536)
    return shown


def test_every_option_is_known(scripts: Path) -> None:
    text = {shell: (scripts / shell).read_text() for shell in ("bash", "zsh", "fish")}
    for command in commands():
        for spelling in (each for option in command.options for each in option.spellings):
            assert spelling in text["bash"] and spelling in text["zsh"]
            assert f" {spelling.lstrip('-')} " in text["fish"]
