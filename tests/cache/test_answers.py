"""An answer is given again while nothing has changed that it depends on, and then only."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from bringup_lint.cache import answers
from bringup_lint.cache import program as program_module
from bringup_lint.cli import answering
from bringup_lint.discover import record
from tests.cache.running import Program
from tests.cache.running import entry
from tests.conftest import PROJECT

UNIT = "[Unit]\nDescription=Rover\n\n[Service]\nExecStart=/usr/bin/rover\nRestart=sometimes\n"


@pytest.fixture
def robot(program: Program) -> Program:
    (program.tree / "etc/systemd/system").mkdir(parents=True)
    (program.tree / "etc/systemd/system/rover.service").write_text(UNIT)
    (program.tree / "notes.txt").write_text("nothing")
    return program


def unit_of(robot: Program) -> Path:
    return robot.tree / "etc/systemd/system/rover.service"


def test_the_second_run_repeats_the_first(robot: Program) -> None:
    first, second = robot.run(), robot.run()
    assert (first.is_answered, second.is_answered) == (False, True)
    assert first.shown == second.shown
    assert "rover.service" in second.text and second.code == 1


def test_a_change_of_a_module_that_a_node_imports_is_seen(program: Program) -> None:
    shutil.copytree(PROJECT / "fixtures/node/topic_name_invalid/bad_modules", program.tree, dirs_exist_ok=True)
    first, second = program.run(), program.run()
    assert second.is_answered and "topics.py:5:14: error[node/topic-name-invalid]" in first.text
    module = program.tree / "mower/mower/topics.py"
    module.write_text(module.read_text().replace("-", "_"))
    third = program.run()
    assert not third.is_answered and "topic-name-invalid" not in third.text


def test_stamps_are_trusted_when_files_are_old_enough(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    robot.run()
    monkeypatch.setattr(record, "YOUNG", 0)
    assert robot.run().is_answered
    monkeypatch.setattr("bringup_lint.discover.again.fact_now", lambda *look: pytest.fail("read once more"))
    assert robot.run().is_answered


def test_a_known_answer_loads_no_rule_and_no_library(robot: Program) -> None:
    environment = {**os.environ, "PYTHONPATH": str(PROJECT), "XDG_CACHE_HOME": str(robot.base)}
    command = [sys.executable, "-X", "importtime", "-m", "bringup_lint"]
    runs = [subprocess.run(command, cwd=robot.tree, env=environment, capture_output=True, text=True) for _ in range(2)]
    assert runs[0].stdout == runs[1].stdout != ""
    first, second = ({line.rpartition("|")[2].strip() for line in run.stderr.splitlines()} for run in runs)
    heavy = {"bringup_lint.engine", "bringup_lint.config", "bringup_lint.report"}
    assert heavy & first == heavy
    assert {*heavy, "click", "hashlib", "json"} & second == set()


def edit(path: Path) -> None:
    path.write_text(UNIT.replace("rover", "robot"))


def edit_unseen(path: Path) -> None:
    """The same size, and the times as they were: the kernel's own time of the change is another."""
    status = path.stat()
    path.write_text(UNIT.replace("rover", "robot"))
    os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))


def replace(path: Path) -> None:
    new = path.with_suffix(".new")
    edit_unseen(path)
    path.rename(new)
    new.rename(path)


CHANGES: dict[str, Callable[[Path], object]] = {
    "edited": edit,
    "edited, times restored": edit_unseen,
    "replaced": replace,
    "removed": lambda path: path.unlink(),
    "another mode": lambda path: path.chmod(0o600),
    "a drop-in": lambda path: [
        Path(f"{path}.d").mkdir(),
        Path(f"{path}.d/own.conf").write_text("[Service]\nExecStart=\nExecStart=/bin/true\n"),
    ],
    "a configuration": lambda path: Path("bringup-lint.toml").write_text('ignore = ["systemd"]\n'),
    "a configuration above": lambda path: Path("../bringup-lint.toml").write_text('ignore = ["systemd"]\n'),
    "a folder becomes a link": lambda path: [
        Path("etc/systemd/system").rename("../elsewhere"),
        Path("etc/systemd/system").symlink_to("../../../elsewhere"),
    ],
}


@pytest.mark.parametrize("is_old", [True, False])
@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES.keys())
def test_a_change_is_seen(
    robot: Program, change: Callable[[Path], object], is_old: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    if is_old:
        monkeypatch.setattr(record, "YOUNG", 20_000_000)
        time.sleep(0.03)
    robot.run()
    time.sleep(0.03)
    change(unit_of(robot))
    now = robot.run()
    assert not now.is_answered
    assert now.shown == robot.run("--no-cache").shown


def test_what_the_run_did_not_read_may_change(robot: Program) -> None:
    """The end of a file of which only the first bytes decided that it is none of ours; times alone say nothing."""
    robot.tree.joinpath("long.txt").write_text("a" * 100_000)
    robot.run()
    robot.tree.joinpath("long.txt").write_text("a" * 100_000 + "b")
    os.utime(unit_of(robot))
    assert robot.run().is_answered


@pytest.mark.parametrize(
    "arguments", [["--min-severity", "info"], ["--colour"], ["--output-format", "json"], ["etc"], ["--no-ignores"]]
)
def test_another_command_line_is_another_question(robot: Program, arguments: list[str]) -> None:
    robot.run()
    if "--output-format" in arguments:
        arguments += ["--output-file", "../report"]
    assert not robot.run(*arguments).is_answered


@pytest.mark.parametrize(("name", "value"), [("COLUMNS", "41"), ("FORCE_COLOR", "1"), ("GIT_INDEX_FILE", "/x")])
def test_the_terminal_is_part_of_the_question(
    robot: Program, name: str, value: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    robot.run()
    monkeypatch.setenv(name, value)
    assert not robot.run().is_answered


def test_the_day_and_the_program_are_part_of_the_answer(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    robot.run()
    monkeypatch.setattr(program_module, "__version__", "99")
    assert not robot.run().is_answered
    assert robot.run().is_answered
    monkeypatch.setattr(time, "strftime", lambda form: "2099-01-01")
    assert not robot.run().is_answered


def test_a_rule_that_is_edited_answers_anew(robot: Program, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    package = tmp_path / "installed/bringup_lint"
    (package / "rules/systemd").mkdir(parents=True)
    rule = package / "rules/systemd/own.py"
    rule.write_text("1")
    monkeypatch.setattr(program_module, "_PACKAGE", str(package))
    robot.run()
    assert robot.run().is_answered
    rule.write_text("2")
    assert not robot.run().is_answered
    (package / "rules/__pycache__").mkdir()
    assert robot.run().is_answered


@pytest.mark.parametrize(
    "arguments",
    [
        ["--output-format", "sarif", "--output-file", "../report"],
        ["--write-baseline", "../baseline"],
        ["--diff"],
        ["--fix"],
        ["--no-cache"],
        ["--rules", "../own"],
        ["missing"],
    ],
)
def test_what_does_more_than_to_answer_is_not_kept(robot: Program, arguments: list[str]) -> None:
    (robot.tree.parent / "own").mkdir()
    robot.run(*arguments)
    assert robot.entries == []


def test_rules_of_a_named_configuration_are_run_each_time(robot: Program) -> None:
    (robot.tree.parent / "own").mkdir()
    (robot.tree.parent / "mine.toml").write_text('rules = ["own"]\n')
    robot.run("--config", "../mine.toml")
    assert robot.entries == []


def test_the_variable_switches_the_cache_off(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(answering.OFF, "1")
    robot.run()
    assert not robot.base.exists()


def test_a_baseline_may_change(robot: Program) -> None:
    robot.run("--write-baseline", "../known.json")
    assert robot.run("--baseline", "../known.json").code == 0
    assert robot.run("--baseline", "../known.json").is_answered
    (robot.tree.parent / "known.json").write_text('{"version": 1, "findings": []}')
    assert robot.run("--baseline", "../known.json").code == 1


def test_a_copy_has_the_same_answer_by_content(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    """As after a checkout in CI: new inodes and times everywhere, also of the program."""
    first = robot.run("--cache-by", "content")
    files = {path: path.read_bytes() for path in robot.tree.rglob("*") if path.is_file()}
    for path, content in files.items():
        path.unlink()
        path.write_bytes(content)
    monkeypatch.setattr(program_module, "_times", lambda path: pytest.fail("times do not count"))
    second = robot.run("--cache-by", "content")
    assert second.is_answered and second.shown == first.shown
    edit(unit_of(robot))
    assert not robot.run("--cache-by", "content").is_answered


def test_the_times_in_an_index_of_git_say_nothing(robot: Program) -> None:
    """git renews them whenever it looks at the files, as pre-commit makes it do."""
    git = ["git", "-c", "user.name=x", "-c", "user.email=x@example.org"]
    for command in (["init", "-q"], ["add", "."]):
        subprocess.run([*git, *command], cwd=robot.tree, check=True)
    found = robot.run("--tracked")
    os.utime(unit_of(robot), (1, 1))
    index = robot.tree / ".git/index"
    before = index.read_bytes()
    subprocess.run([*git, "update-index", "--refresh"], cwd=robot.tree, check=True)
    assert index.read_bytes() != before
    again = robot.run("--tracked")
    assert again.is_answered and again.shown == found.shown
    subprocess.run([*git, "rm", "-q", "--cached", "-r", "."], cwd=robot.tree, check=True)
    assert not robot.run("--tracked").is_answered


def test_what_is_said_of_closed_files_is_said_again(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("bringup_lint.cli.streams.said", ["bringup-lint: a note\n"])
    monkeypatch.setattr(answering, "said", ["bringup-lint: a note\n"])
    robot.run()
    assert robot.run().said == "bringup-lint: a note\n"


def test_no_secret_is_kept(robot: Program) -> None:
    (robot.tree / "docker-compose.yml").write_text(
        "services:\n  db:\n    image: postgres:16\n    environment:\n      POSTGRES_PASSWORD: kX9vQ2mZt7Lw\n"
    )
    found = robot.run()
    assert "docker-compose.yml" in found.text
    assert "password" in found.text.lower()
    assert b"kX9vQ2mZt7Lw" not in b"".join(path.read_bytes() for path in robot.entries)


def test_what_was_looked_at_is_absolute(robot: Program) -> None:
    robot.run()
    assert all(look[1].startswith("/") for look in entry(robot.entries[0])["seen"])


def test_a_name_that_no_encoding_has_is_looked_at_again(robot: Program) -> None:
    path = os.fsencode(robot.tree / "etc") + b"/\xff.conf"
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "wb") as file:
        file.write(b"a\n")
    first, second = robot.run(), robot.run()
    assert second.is_answered and second.shown == first.shown
    os.rename(path, path + b"x")
    assert not robot.run().is_answered


def test_an_answer_with_a_nul_is_not_kept() -> None:
    assert not answers._is_text(answers.Answer("a\0b", "", 0))


@pytest.mark.parametrize("body", [b"", b"a\0b", b"name\0program\0text\0said\0002", b"n\0p\0t\0s\0001\0n\0/etc"])
def test_what_lacks_a_part_is_no_entry(body: bytes) -> None:
    assert answers._entry(body) is None
