"""The manual page is that of the commands, and the real formatters take it; ``--update-expected`` rewrites it."""

from __future__ import annotations

import shutil
import subprocess

import pytest

from bringup_lint.cli.syntax import commands
from tests.conftest import PROJECT
from tests.docs.man_page import page
from tests.lint import lint

FILE = PROJECT / "docs" / "bringup-lint.1"


def test_page_is_current(update_expected: bool) -> None:
    if update_expected:
        FILE.write_text(page(), "utf-8")
    assert FILE.read_text("utf-8") == page()


def formatted(*command: str) -> str:
    if shutil.which(command[0]) is None:
        pytest.skip(f"{command[0]} is not installed")
    environment = {"PATH": "/usr/bin:/bin", "MANWIDTH": "80", "LC_ALL": "C.UTF-8", "MANROFFOPT": "-Wall"}
    run = subprocess.run([*command, str(FILE)], capture_output=True, text=True, env=environment, check=True)
    assert run.stderr == ""
    return run.stdout


def test_mandoc_warns_of_nothing_but_the_date() -> None:
    if shutil.which("mandoc") is None:
        pytest.skip("mandoc is not installed")
    run = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", FILE], capture_output=True, text=True)
    assert [line for line in (run.stdout + run.stderr).splitlines() if "missing date" not in line] == []


@pytest.mark.parametrize("command", [["man", "-l"], ["mandoc", "-T", "utf8"]])
def test_page_shows_every_option(command: list[str]) -> None:
    if command[0] == "man" and shutil.which("groff") is None:
        pytest.skip("groff is not installed")
    shown = formatted(*command)
    while "\b" in shown:
        at = shown.index("\b")
        shown = shown[: at - 1] + shown[at + 1 :]
    for made in commands():
        assert made.name in shown
        for option in made.options:
            assert option.spellings[0] in shown


def test_help_has_the_commands_first_and_then_every_option() -> None:
    text = lint("--help", cwd=PROJECT).stdout
    assert text.index("Commands:") < text.index("What is checked:") < text.index("Exit codes:")
    check = next(commands())
    assert [option.spellings[0] for option in check.options if option.spellings[0] not in text] == []
