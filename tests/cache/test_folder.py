"""Whatever somebody does to the folder of the cache, a run says what it says without one."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from bringup_lint.cache import folder as folders
from bringup_lint.discover import record
from tests.cache.running import Program
from tests.cache.running import Run
from tests.cache.running import entry
from tests.conftest import PROJECT

STRANGER = 54321
needs_root = pytest.mark.skipif(os.geteuid() != 0, reason="gives files to another user")


@pytest.fixture
def robot(program: Program) -> Program:
    (program.tree / "rover.service").write_text("[Service]\nExecStart=/usr/bin/rover\nRestart=sometimes\n")
    return program


def only(robot: Program) -> Path:
    (path,) = robot.entries
    return path


def test_the_folder_is_closed_to_others(robot: Program) -> None:
    before = os.umask(0)
    try:
        robot.run()
    finally:
        os.umask(before)
    assert robot.folder.stat().st_mode & 0o777 == 0o700
    assert {path.stat().st_mode & 0o777 for path in robot.folder.iterdir()} == {0o600}


def damage(at: int) -> Callable[[Program], None]:
    def change(robot: Program) -> None:
        data = bytearray(only(robot).read_bytes())
        data[at * len(data) // 10] ^= 1
        only(robot).write_bytes(data)

    return change


def swap(robot: Program) -> None:
    """The answer to another question, in this one's place."""
    own = only(robot)
    robot.run("--ignore", "systemd")
    (other,) = (path for path in robot.entries if path != own)
    other.replace(own)


def as_fifo(robot: Program) -> None:
    path = only(robot)
    path.unlink()
    os.mkfifo(path, 0o600)


def as_link(robot: Program) -> None:
    path = only(robot)
    path.rename(robot.base / "moved")
    path.symlink_to(robot.base / "moved")


def as_folder(robot: Program) -> None:
    path = only(robot)
    path.unlink()
    path.mkdir()


def huge(robot: Program) -> None:
    os.truncate(only(robot), folders.LARGEST + 1)


def linked_folder(robot: Program) -> None:
    robot.folder.rename(robot.base / "moved")
    robot.folder.symlink_to(robot.base / "moved")


def file_as_folder(robot: Program) -> None:
    shutil.rmtree(robot.folder)
    robot.folder.write_text("")


def of_a_stranger(robot: Program) -> None:
    os.chown(robot.folder, STRANGER, STRANGER)


def entry_of_a_stranger(robot: Program) -> None:
    os.chown(only(robot), STRANGER, STRANGER)


ATTACKS: dict[str, Callable[[Program], object]] = {
    **{f"a bit flipped at {at}0 %": damage(at) for at in range(10)},
    "cut off": lambda robot: os.truncate(only(robot), only(robot).stat().st_size // 2),
    "empty": lambda robot: os.truncate(only(robot), 0),
    "huge": huge,
    "another question's answer": swap,
    "a FIFO": as_fifo,
    "a link": as_link,
    "a folder": as_folder,
    "readable by others": lambda robot: only(robot).chmod(0o644),
    "writable by others": lambda robot: only(robot).chmod(0o602),
    "another key": lambda robot: (robot.folder / "key").write_bytes(bytes(32)),
    "no key": lambda robot: (robot.folder / "key").unlink(),
    "a short key": lambda robot: (robot.folder / "key").write_bytes(b"1"),
    "an open folder": lambda robot: robot.folder.chmod(0o755),
    "a folder open to a group": lambda robot: robot.folder.chmod(0o770),
    "a linked folder": linked_folder,
    "a file in place of the folder": file_as_folder,
}


@pytest.mark.parametrize("attack", ATTACKS.values(), ids=ATTACKS.keys())
def test_an_odd_cache_is_none(robot: Program, attack: Callable[[Program], object]) -> None:
    first = robot.run()
    attack(robot)
    again = robot.run()
    assert not again.is_answered
    assert again.shown == first.shown


@needs_root
@pytest.mark.parametrize("attack", [of_a_stranger, entry_of_a_stranger])
def test_what_belongs_to_another_user_is_not_read(robot: Program, attack: Callable[[Program], None]) -> None:
    first = robot.run()
    attack(robot)
    again = robot.run()
    assert not again.is_answered and again.shown == first.shown


@needs_root
def test_root_leaves_nothing_in_the_home_of_a_user(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    """``sudo`` may keep HOME."""
    home = robot.base.parent / "home"
    (home / ".cache").mkdir(parents=True)
    for path in (home, home / ".cache"):
        os.chown(path, STRANGER, STRANGER)
    monkeypatch.delenv("XDG_CACHE_HOME")
    monkeypatch.setenv("HOME", str(home))
    assert robot.run().code == 1
    os.chown(home / ".cache", 0, 0)
    assert robot.run().code == 1
    assert [path.name for path in home.rglob("*")] == [".cache"]


@needs_root
def test_root_does_not_read_the_cache_of_a_user(robot: Program) -> None:
    robot.run()
    for path in (robot.folder, *robot.folder.iterdir()):
        os.chown(path, STRANGER, STRANGER)
    assert not robot.run().is_answered


@pytest.mark.parametrize(
    "variables",
    [
        {"HOME": None, "XDG_CACHE_HOME": None},
        {"HOME": "", "XDG_CACHE_HOME": ""},
        {"HOME": "relative", "XDG_CACHE_HOME": "relative"},
        {"HOME": "/proc/nothing", "XDG_CACHE_HOME": None},
        {"XDG_CACHE_HOME": "/proc/1/nothing"},
        {"XDG_CACHE_HOME": "/dev/null"},
    ],
)
def test_nowhere_to_keep_it(robot: Program, variables: dict[str, str | None], monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in variables.items():
        if value is None:
            monkeypatch.delenv(name, raising=False)
        else:
            monkeypatch.setenv(name, value)
    first, second = robot.run(), robot.run()
    assert first.shown == second.shown and first.code == 1
    assert not second.is_answered
    assert [path.name for path in robot.tree.iterdir()] == ["rover.service"]


def test_a_home_without_a_cache_folder_gets_one(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    home = robot.base.parent / "home"
    home.mkdir()
    monkeypatch.setenv("XDG_CACHE_HOME", "relative")
    monkeypatch.setenv("HOME", str(home))
    robot.run()
    assert robot.run().is_answered
    assert (home / ".cache/bringup-lint/key").exists()


def test_a_full_disk_costs_the_answer_only(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(*words: object, **more: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(folders.os, "rename", full)
        assert robot.run().code == 1
    assert robot.entries == []


def test_a_clock_that_was_put_back_makes_stamps_worthless(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    """When the clock reads an hour once more, a change could get the very time that is known."""
    now = time.time_ns()
    monkeypatch.setattr(record, "YOUNG", 0)
    monkeypatch.setattr(time, "time_ns", lambda: now - 3_600_000_000_000)
    robot.run()
    stamps = [look[2] for look in entry(only(robot))["seen"] if look[1].endswith("rover.service")]
    assert stamps and not any(stamps)


def test_the_oldest_answers_are_removed(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(folders, "MOST_ENTRIES", 3)
    for number in range(4):
        robot.run("--min-severity", "info", "--exclude", f"x{number}")
        os.utime(robot.entries[0].parent)
        time.sleep(0.01)
    assert len(robot.entries) == 3
    assert robot.run("--min-severity", "info", "--exclude", "x1").is_answered
    time.sleep(0.01)
    robot.run("--min-severity", "info", "--exclude", "x4")
    assert robot.run("--min-severity", "info", "--exclude", "x1").is_answered
    assert not robot.run("--min-severity", "info", "--exclude", "x2").is_answered


def test_the_cache_stays_small(robot: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    robot.run()
    monkeypatch.setattr(folders, "MOST", only(robot).stat().st_size * 5 // 2)
    for number in range(4):
        robot.run("--exclude", f"x{number}")
    assert sum(path.stat().st_size for path in robot.entries) <= folders.MOST
    monkeypatch.setattr(folders, "LARGEST", 10)
    robot.run("--exclude", "y")
    assert not robot.run("--exclude", "y").is_answered


def test_what_was_never_finished_is_removed(robot: Program) -> None:
    robot.run()
    old, new = robot.folder / ".0123", robot.folder / ".4567"
    for path in (old, new):
        path.write_text("")
    os.utime(old, (time.time() - 7200,) * 2)
    robot.run("--exclude", "x")
    assert (old.exists(), new.exists()) == (False, True)


@pytest.mark.slow
def test_many_processes_at_once(robot: Program) -> None:
    environment = {**os.environ, "PYTHONPATH": str(PROJECT), "XDG_CACHE_HOME": str(robot.base)}
    command = [sys.executable, "-m", "bringup_lint", "--output-format", "concise"]
    for _ in range(2):
        started = [
            subprocess.Popen(command, cwd=robot.tree, env=environment, stdout=subprocess.PIPE, text=True)
            for _ in range(4)
        ]
        texts = {process.communicate()[0] for process in started}
        assert len(texts) == 1 and "Restart" in texts.pop()
        assert {process.returncode for process in started} == {1}
    assert [path.name[0] == "." for path in robot.entries] == [False]


def test_an_answer_that_nobody_reads_ends_quietly(robot: Program) -> None:
    robot.run()
    shown: Run = robot.run()
    assert shown.is_answered
    environment = {**os.environ, "PYTHONPATH": str(PROJECT), "XDG_CACHE_HOME": str(robot.base)}
    command = f"{sys.executable} -m bringup_lint --output-format concise"
    for _ in range(2):
        process = subprocess.run(
            ["sh", "-c", f"{command} | true"], cwd=robot.tree, env=environment, capture_output=True, text=True
        )
        assert process.stderr == ""
