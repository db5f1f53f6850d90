"""What needs no click does what click would do."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from bringup_lint.cli.commands.check import command
from bringup_lint.cli.run_options import RunOptions
from tests.conftest import PROJECT
from tests.lint import lint

UNIT = "[Service]\nExecStart=/usr/bin/sh -c 'ros2 launch rover rover.launch.py'\n"


def test_the_defaults_are_those_of_the_options() -> None:
    with command.make_context("bringup-lint", []) as context:
        defaults = vars(RunOptions())
        del defaults["stdin_data"]
        assert context.params == {**defaults, "paths": ()}


@pytest.mark.parametrize(
    ("plain", "given"),
    [
        (["rover.service"], ["--cache-by", "times", "rover.service"]),
        ([], ["--cache-by", "times"]),
        (["check", "."], ["check", "--cache-by", "times", "."]),
        (["missing.service"], ["--cache-by", "times", "missing.service"]),
        (["rules"], ["rules", "--output-format", "text"]),
        (["rules", "can", "udev"], ["rules", "can", "udev", "--output-format", "text"]),
        (["rules", "cann"], ["rules", "cann", "--output-format", "text"]),
        (["explain", "systemd/root-user"], ["explain", "--no-colour", "systemd/root-user"]),
        (["explain", "root-user"], ["explain", "--no-colour", "root-user"]),
        (["explain", "no such line"], ["explain", "--no-colour", "no such line"]),
    ],
)
def test_commands_without_options_answer_as_with_them(plain: list[str], given: list[str], tmp_path: Path) -> None:
    (tmp_path / "rover.service").write_text(UNIT)
    assert lint(*plain, cwd=tmp_path) == lint(*given, cwd=tmp_path)


@pytest.mark.parametrize("words", [["rover.service"], ["rules"], ["explain", "systemd/root-user"]])
def test_no_command_without_options_loads_click(words: list[str], tmp_path: Path) -> None:
    (tmp_path / "rover.service").write_text(UNIT)
    code = f"""
import sys
sys.path.insert(0, {str(PROJECT)!r})
from bringup_lint.cli import dispatch
try:
    dispatch({words!r})
except SystemExit:
    pass
print("click" in sys.modules)"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=tmp_path, check=True)
    assert run.stdout.endswith("False\n")
