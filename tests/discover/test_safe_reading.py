"""Untrusted trees: whatever lies in the way is said or skipped, the rest is checked, nothing runs, writes or
connects."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from bringup_lint.discover.reading import SIZE_LIMIT
from bringup_lint.discover.reading import Begun
from bringup_lint.discover.reading import Unreadable
from bringup_lint.discover.reading import begin
from bringup_lint.discover.reading import read_bytes
from bringup_lint.discover.reading import read_head
from tests.conftest import PROJECT
from tests.lint import lint

UNIT = "[Service]\nExecStart=/bin/true\n"


def concise(*arguments: str | Path, cwd: Path):
    return lint("--select", "lint", "--output-format", "concise", *arguments, cwd=cwd)


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A tree whose last file has a finding: who reports it got through everything before."""
    (tmp_path / "zz.service").write_bytes(b"[Service]\nExecStart=/bin/\xff\n")
    return tmp_path


def got_through(run) -> bool:
    return run.code == 1 and "zz.service:1:1: error[lint/encoding]" in run.stdout


def test_fifo_is_skipped_on_the_way_and_reported_by_name(tree: Path) -> None:
    os.mkfifo(tree / "pipe.service")
    assert got_through(concise(cwd=tree))
    assert (
        "pipe.service:1:1: error[lint/unreadable] Not checked: not a regular file but a FIFO"
        in concise("pipe.service", cwd=tree).stdout
    )


def test_link_to_a_fifo_does_not_block(tree: Path) -> None:
    os.mkfifo(tree / "pipe")
    (tree / "link.service").symlink_to("pipe")
    assert got_through(concise(cwd=tree))


def test_socket_and_device_are_skipped(tree: Path) -> None:
    with socket.socket(socket.AF_UNIX) as bound:
        here = os.getcwd()
        os.chdir(tree)
        bound.bind("s.service")
        os.chdir(here)
        (tree / "null.service").symlink_to("/dev/zero")
        assert got_through(concise(cwd=tree))


def test_loops_and_dangling_links(tree: Path) -> None:
    (tree / "loop").symlink_to(".")
    (tree / "a.service").symlink_to("b.service")
    (tree / "b.service").symlink_to("a.service")
    (tree / "gone.service").symlink_to("nowhere")
    assert got_through(concise(cwd=tree))


def test_links_out_of_the_tree_are_not_followed(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    outside = tmp_path_factory.mktemp("outside") / "secret.service"
    outside.write_bytes(b"[Service]\nExecStart=/bin/\xff\n")
    (tree / "link.service").symlink_to(outside)
    run = concise(cwd=tree)
    assert got_through(run)
    assert "link.service" not in run.stdout


@pytest.mark.skipif(os.geteuid() == 0, reason="root reads everything")
def test_no_permission(tree: Path) -> None:
    (tree / "closed").mkdir(mode=0)
    (tree / "closed.service").write_text(UNIT)
    (tree / "closed.service").chmod(0)
    run = concise(cwd=tree)
    assert got_through(run)
    assert run.stdout.count("lint/unreadable") == 2


def test_nul_bytes_and_utf_16(tree: Path) -> None:
    (tree / "nul.service").write_bytes(b"[Service]\0\nExecStart=/bin/true\n")
    (tree / "wide.service").write_text(UNIT, "utf-16")
    (tree / "etc/systemd/system").mkdir(parents=True)
    (tree / "etc/systemd/system/nul.service").write_bytes(b"\0\0\0")
    run = concise(cwd=tree)
    assert got_through(run)
    assert "etc/systemd/system/nul.service:1:1: error[lint/encoding] The file contains NUL bytes" in run.stdout


@pytest.mark.parametrize("select", [("lint",), ("lint", "host"), ("host", "lint")])
def test_no_rule_makes_a_file_of_no_kind_known_for_its_encoding(tree: Path, select: tuple[str, ...]) -> None:
    (tree / "ser2net.yaml").write_bytes(b"connection: &a\n  accepter: tcp,3001 # \xff\n")
    (tree / "etc").mkdir()
    (tree / "etc/host.conf").write_text(UNIT)
    run = lint(*(word for each in select for word in ("--select", each)), "--output-format", "concise", cwd=tree)
    assert got_through(run)
    assert run.stdout.count("lint/encoding") == 1


def test_a_compiled_program_is_no_damaged_script(tree: Path) -> None:
    (tree / "drive").mkdir()
    (tree / "drive/rover").write_bytes(b"\x7fELF\2\1\1\0" + bytes(100))
    (tree / "drive/rover.service").write_text("[Service]\nExecStart=/opt/rover/drive/rover\n")
    (tree / "etc/systemd/system").mkdir(parents=True)
    (tree / "etc/systemd/system/other.service").write_bytes(b"\x7fELF\2\1\1\0")
    run = concise("--select", "host", cwd=tree)
    assert "drive/rover:1" not in run.stdout
    assert "etc/systemd/system/other.service:1:1: error[lint/encoding] The file is a compiled program" in run.stdout


def test_no_module_of_the_folder_is_imported(tmp_path: Path) -> None:
    for name in ("json.py", "re.py", "click.py"):
        (tmp_path / name).write_text("open('ran', 'w')\n")
    (tmp_path / "robot.service").write_text(UNIT)
    run = subprocess.run(
        [sys.executable, "-m", "bringup_lint", "."],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(PROJECT)},
    )
    assert "1 file checked" in run.stdout, run.stderr
    assert not (tmp_path / "ran").exists()


def test_large_file_is_reported_not_read(tree: Path) -> None:
    with (tree / "large.service").open("wb") as file:
        file.write(b"[Service]\n")
        file.truncate(SIZE_LIMIT + 1)
    run = concise(cwd=tree)
    assert got_through(run)
    assert "large.service:1:1: error[lint/unreadable]" in run.stdout


@pytest.mark.parametrize("line", ["A=" + "x" * (1 << 20) + "\n", "A=x \\\n" + ("x" * 1000 + " \\\n") * 1100 + "y\n"])
def test_a_line_for_which_systemd_refuses_a_unit_is_reported(tree: Path, line: str) -> None:
    (tree / "long.service").write_text(f"[Service]\nExecStart=/bin/true\nEnvironment={line}")
    run = concise(cwd=tree)
    assert got_through(run)
    assert "long.service:3:1: error[lint/unreadable] Not checked: this line is longer than 1 MiB" in run.stdout
    (tree / "long.service").write_text(f"[Service]\nExecStart=/bin/true\nEnvironment={line[-900_000:]}")
    assert "lint/unreadable" not in "".join(each for each in concise(cwd=tree).stdout.splitlines() if "long" in each)


@pytest.mark.slow
def test_million_lines(tree: Path) -> None:
    (tree / "long.service").write_text("[Service]\n" + "A=1\n" * 1_000_000)
    assert got_through(concise(cwd=tree))


def test_vanished_file(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint.discover import tree as reading
    from bringup_lint.discover.kinds import HEAD_SIZE

    real = reading.read_bytes

    def vanish(path: str, *rest, **more):
        if path.endswith("brief.service"):
            os.unlink(path)
        return real(path, *rest, **more)

    (tree / "brief.service").write_text(UNIT + "# more than a kind looks at\n" * HEAD_SIZE)
    monkeypatch.setattr(reading, "read_bytes", vanish)
    run = concise(cwd=tree)
    assert got_through(run)
    assert "brief.service:1:1: error[lint/unreadable] Not checked: No such file or directory" in run.stdout


def test_odd_names(tree: Path) -> None:
    for name in ("with blank.service", "new\nline.service", "\udcff.service", "-rf.service", "ünï.service"):
        (tree / os.fsencode(name).decode("utf-8", "surrogateescape")).write_text(UNIT)
    assert got_through(concise(cwd=tree))


def test_deep_tree(tree: Path) -> None:
    deep = tree
    for _ in range(200):
        deep = deep / "d"
    deep.mkdir(parents=True)
    assert got_through(concise(cwd=tree))


GUARD = """
import os, sys

def hook(event, arguments):
    if event == "open":
        path, mode, flags = arguments
        if flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT) and "__pycache__" not in str(path):
            print("GUARD", event, path)
    elif event.startswith(("socket.", "subprocess.", "os.exec", "os.spawn", "os.posix_spawn", "os.system", "os.fork",
                           "os.remove", "os.rename", "os.mkdir", "ctypes.dlopen")):
        if "__pycache__" not in str(arguments):
            print("GUARD", event, arguments)

from bringup_lint.cli import dispatch
sys.addaudithook(hook)
try:
    dispatch(sys.argv[1:])
except SystemExit as stop:
    print("EXIT", stop.code)
"""


def test_nothing_is_run_written_or_connected_to(tmp_path: Path) -> None:
    evil = {
        "etc/systemd/system/evil.service": (
            "[Service]\nExecStart=/bin/sh -c 'touch ran'\nExecStartPre=/usr/bin/evil.sh\n"
        ),
        "usr/bin/evil.sh": "#!/bin/sh\ntouch ran\n",
        "launch/evil.launch.py": "open('ran', 'w')\nimport os\nos.system('touch ran')\n"
        "def generate_launch_description():\n    open('ran', 'w')\n",
        "launch/evil.launch.xml": '<!DOCTYPE launch [<!ENTITY x SYSTEM "file:///etc/passwd">]><launch>&x;</launch>',
        "config/evil.yaml": "!!python/object/apply:os.system ['touch ran']\n",
        "setup.py": "open('ran', 'w')\n",
        "conftest.py": "open('ran', 'w')\n",
        "sitecustomize.py": "open('ran', 'w')\n",
        "bringup_lint/__init__.py": "open('ran', 'w')\n",
        "rules/systemd/evil.py": "open('ran', 'w')\n",
        "etc/netplan/x.yaml": "network: {version: 2}\n",
        "cyclonedds.xml": '<CycloneDDS xmlns:xi="http://www.w3.org/2001/XInclude"><xi:include href="http://127.0.0.1:9/"/></CycloneDDS>',
    }
    for name, text in evil.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    run = subprocess.run(
        [sys.executable, "-P", "-c", GUARD, "--min-severity", "info", "--output-format", "json", "."]
        if sys.version_info >= (3, 11)
        else [sys.executable, "-I", "-c", GUARD, "--min-severity", "info", "--output-format", "json", "."],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(PROJECT), "PYTHONDONTWRITEBYTECODE": "1"},
    )
    assert "EXIT" in run.stdout, run.stderr
    assert "GUARD" not in run.stdout
    assert not list(tmp_path.rglob("ran"))


def test_a_small_file_is_opened_once(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    opened: list[str] = []
    real = os.open

    def counted(path: str, *rest, **more):
        opened.append(os.path.basename(path))
        return real(path, *rest, **more)

    (tree / "small.yaml").write_text("driver:\n  ros__parameters:\n    port: 1\n")
    monkeypatch.setattr(os, "open", counted)
    assert got_through(concise(cwd=tree))
    assert opened.count("small.yaml") == 1


@pytest.fixture
def fifo(tmp_path: Path) -> Iterator[Path]:
    """One that has something to read, and somebody who may write more."""
    path = tmp_path / "fifo"
    os.mkfifo(path)
    end = os.open(path, os.O_RDWR)
    os.write(end, b"[Service]\n")
    yield path
    os.close(end)


def test_only_regular_files_are_read(fifo: Path) -> None:
    words = {fifo: "a FIFO", Path("/dev/null"): "a character device", fifo.parent: "a directory"}
    for path, word in words.items():
        for follow in (False, True):
            with pytest.raises(Unreadable, match=f"not a regular file but {word}"):
                read_bytes(str(path), follow=follow)
        assert begin(str(path), 10) == Begun(str(path), 10)
        assert read_head(str(path), 10) == ""
