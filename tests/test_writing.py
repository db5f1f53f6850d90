"""Nothing outside of the tree is written, and a file that cannot be written costs nothing but itself."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from pathlib import Path
from shutil import which

import pytest

from bringup_lint import writing
from tests.conftest import PROJECT
from tests.lint import Run
from tests.lint import lint

UNIT = (
    "[Unit]\nAfter=network.target\n\n[Service]\nExecStart=/usr/bin/ros2 launch a b.launch.py\nStartLimitInterval=200\n"
)
as_root = pytest.mark.skipif(os.geteuid() != 0 or not which("setpriv"), reason="only root gives files away")


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    folder = tmp_path / "checkout"
    folder.mkdir()
    (folder / "a.service").write_text(UNIT)
    (folder / "z.service").write_text(UNIT.replace("b.launch", "z.launch"))
    return folder


def fix(tree: Path, *arguments: str | Path) -> Run:
    return lint(
        "--fix",
        "--unsafe-fixes",
        "--select",
        "systemd/network-target",
        "--output-format",
        "concise",
        *arguments,
        cwd=tree,
    )


def is_fixed(path: Path) -> bool:
    return "network-online.target" in path.read_text()


def leftovers(folder: Path) -> list[str]:
    return [name for name in os.listdir(folder) if name.startswith(".")]


def test_a_planted_link_beside_a_file_is_not_written_through(tree: Path) -> None:
    victim = tree.parent / "victim"
    victim.write_text("precious\n")
    victim.chmod(0o600)
    for name in (".a.service.bringup-lint", ".bringup-lint"):
        (tree / name).symlink_to(victim)
    run = fix(tree)
    assert run.code == 0
    assert is_fixed(tree / "a.service")
    assert not (tree / "a.service").is_symlink()
    assert (victim.read_text(), stat.S_IMODE(victim.stat().st_mode)) == ("precious\n", 0o600)


def test_a_planted_fifo_folder_or_long_name_does_not_matter(tree: Path) -> None:
    os.mkfifo(tree / ".a.service.bringup-lint")
    (tree / ".z.service.bringup-lint").mkdir()
    long = tree / f"{'n' * 240}.service"
    long.write_text(UNIT)
    assert fix(tree).code == 0
    assert all(map(is_fixed, (tree / "a.service", tree / "z.service", long)))


@pytest.mark.parametrize("name", [".r.sarif.tmp", "r.sarif"])
def test_a_report_is_not_written_through_a_link(tree: Path, name: str) -> None:
    victim = tree.parent / "victim"
    victim.write_text("precious\n")
    (tree / name).symlink_to(victim)
    run = lint("--exit-zero", "--output-format", "sarif", "--output-file", "r.sarif", ".", cwd=tree)
    assert victim.read_text() == "precious\n"
    assert run.code == (0 if name.endswith("tmp") else 2)


def test_a_report_is_not_written_into_a_linked_folder(tree: Path) -> None:
    outside = tree.parent / "outside"
    outside.mkdir()
    (tree / "reports").symlink_to(outside)
    run = lint("--output-format", "json", "--output-file", "reports/r.json", ".", cwd=tree)
    assert (run.code, run.stdout) == (2, "")
    assert "reports/r.json: a symbolic link leads out of the working folder" in run.stderr
    assert list(outside.iterdir()) == []


def test_a_report_does_not_wait_for_a_fifo(tree: Path) -> None:
    os.mkfifo(tree / "r.json")
    run = lint("--output-format", "json", "--output-file", "r.json", ".", cwd=tree)
    assert run.code == 2
    assert "r.json: it is a FIFO, not a regular file" in run.stderr


def test_a_report_that_cannot_be_written_does_not_cost_the_others(tree: Path) -> None:
    run = lint(
        *("--output-format", "concise", "--output-format", "json", "--output-file", "none/r.json"),
        *("--output-format", "sarif", "--output-file", "r.sarif"),
        *("--select", "systemd/network-target", "."),
        cwd=tree,
    )
    assert run.code == 2
    assert run.stdout.count("systemd/network-target") == 2
    assert "not written: none/r.json: No such file or directory" in run.stderr
    assert (tree / "r.sarif").exists()


def test_a_report_that_cannot_be_written_does_not_cost_the_baseline(tree: Path) -> None:
    failing = ("--output-format", "json", "--output-file", "none/r.json")
    run = lint(*failing, "--write-baseline", "b.json", "--select", "systemd/network-target", ".", cwd=tree)
    assert run.code == 2
    assert "b.json now holds 2 findings" in run.stderr
    assert (tree / "b.json").read_text().count('"rule": "systemd/network-target"') == 2


def test_a_baseline_that_cannot_be_written_does_not_cost_the_report(tree: Path) -> None:
    baseline = ("--write-baseline", "none/b.json", "--select", "systemd/network-target", ".")
    run = lint("--output-format", "concise", *baseline, cwd=tree)
    assert run.code == 2
    assert run.stdout.count("[systemd/network-target]") == 2
    assert "not written: none/b.json: No such file or directory" in run.stderr


def test_a_report_keeps_the_mode_of_the_old_one(tree: Path) -> None:
    report = tree / "r.json"
    report.touch()
    report.chmod(0o600)
    lint("--output-format", "json", "--output-file", "r.json", ".", cwd=tree)
    assert stat.S_IMODE(report.stat().st_mode) == 0o600


@as_root
def test_owner_group_and_mode_stay(tree: Path) -> None:
    path = tree / "a.service"
    os.chown(path, 1234, 5678)
    path.chmod(0o4640)
    assert fix(tree).code == 0
    now = path.stat()
    assert is_fixed(path)
    assert (now.st_uid, now.st_gid, stat.S_IMODE(now.st_mode)) == (1234, 5678, 0o4640)


def test_extended_attributes_stay(tree: Path) -> None:
    path = tree / "a.service"
    try:
        os.setxattr(path, "user.origin", b"fleet")
    except (OSError, AttributeError):
        pytest.skip("the file system has no extended attributes")
    assert fix(tree).code == 0
    assert is_fixed(path)
    assert os.getxattr(path, "user.origin") == b"fleet"


def test_a_private_file_is_never_readable_for_others(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tree / "a.service"
    path.chmod(0o600)
    seen = set()
    fill = writing._fill

    def look(file, content: bytes) -> None:
        seen.add(stat.S_IMODE(os.fstat(file.fileno()).st_mode))
        fill(file, content)

    monkeypatch.setattr(writing, "_fill", look)
    assert fix(tree, "a.service").code == 0
    assert seen == {0o600}


def test_a_private_file_is_private_from_its_first_moment(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Who opens the new file while it is empty could read what is written later."""
    seen = set()
    take_over = writing._take_over

    def look(path: Path, old: int, status: os.stat_result, new: int) -> None:
        seen.add(stat.S_IMODE(os.fstat(new).st_mode))
        take_over(path, old, status, new)

    monkeypatch.setattr(writing, "_take_over", look)
    assert fix(tree, "a.service").code == 0
    assert seen == {0o600}


@pytest.mark.parametrize("kind", ["link", "file"])
def test_a_name_that_was_guessed_is_not_written_to(tree: Path, monkeypatch: pytest.MonkeyPatch, kind: str) -> None:
    victim = tree.parent / "victim"
    victim.write_text("precious\n")
    guessed = tree / f".bringup-lint-{bytes(8).hex()}"
    if kind == "link":
        guessed.symlink_to(victim)
    else:
        os.link(victim, guessed)
    monkeypatch.setattr(writing.os, "urandom", bytes)
    run = fix(tree, "a.service")
    assert run.code == 2
    assert "not written: a.service: " in run.stderr
    assert (victim.read_text(), guessed.exists()) == ("precious\n", True)
    assert (tree / "a.service").read_text() == UNIT


def test_a_file_with_hard_links_is_left_alone_and_the_others_are_fixed(tree: Path) -> None:
    os.link(tree / "a.service", tree.parent / "backup")
    run = fix(tree)
    assert run.code == 2
    assert "not written: a.service: it has 2 names (hard links)" in run.stderr
    assert run.stdout.startswith("a.service:2:7: warning[systemd/network-target]")
    assert not is_fixed(tree / "a.service")
    assert is_fixed(tree / "z.service")


def test_a_file_that_changed_since_it_was_read_is_left_alone(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from bringup_lint import fix as fixing

    def edit(path: Path, was: bytes, content: bytes) -> None:
        if path.name == "a.service":
            path.write_text("# edited meanwhile\n" + UNIT)
        writing.correct(path, was, content)

    monkeypatch.setattr(fixing, "correct", edit)
    run = lint("--fix", "--unsafe-fixes", "--select", "systemd/network-target", "a.service", cwd=tree)
    assert run.code == 2
    assert "a.service: it has changed since it was read" in run.stderr
    assert (tree / "a.service").read_text() == "# edited meanwhile\n" + UNIT
    assert leftovers(tree) == []


SIGNALLED = """
import os, signal, sys
from bringup_lint.__main__ import main
number, synced = getattr(signal, sys.argv.pop(1)), os.fsync
signal.signal(signal.SIGINT, signal.default_int_handler)
def fsync(descriptor):
    os.kill(os.getpid(), number)
    synced(descriptor)
os.fsync = fsync
signal.signal(signal.SIGHUP, signal.SIG_DFL)  # ignored where the tests run below nohup
main()
"""


@pytest.mark.parametrize("name", ["SIGTERM", "SIGHUP", "SIGINT"])
def test_a_signal_leaves_no_file_beside(tree: Path, name: str) -> None:
    arguments = ["--fix", "--unsafe-fixes", "--select", "systemd/network-target", "a.service"]
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}
    command = [sys.executable, "-c", SIGNALLED, name, *arguments]
    run = subprocess.run(command, cwd=tree, capture_output=True, env=environment, check=False)
    assert run.returncode in (130, -15, -1), run.stderr
    assert b"Traceback" not in run.stderr
    assert is_fixed(tree / "a.service")
    assert leftovers(tree) == []


KILLED = """
import os, signal, sys
from bringup_lint.__main__ import main
name, after = sys.argv.pop(1), int(sys.argv.pop(1))
asked = getattr(os, name)
def call(*arguments, **named):
    global after
    after -= 1
    if after < 0:
        os.kill(os.getpid(), signal.SIGKILL)
    return asked(*arguments, **named)
setattr(os, name, call)
main()
"""


@pytest.mark.parametrize("after", range(4))
@pytest.mark.parametrize("call", ["fsync", "replace"])
def test_every_file_is_the_old_or_the_new_one_after_a_kill(tree: Path, call: str, after: int) -> None:
    arguments = ["--fix", "--unsafe-fixes", "--select", "systemd/network-target", "."]
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}
    command = [sys.executable, "-c", KILLED, call, str(after), *arguments]
    run = subprocess.run(command, cwd=tree, capture_output=True, env=environment, check=False)
    old = {"a.service": UNIT, "z.service": UNIT.replace("b.launch", "z.launch")}
    for name, text in old.items():
        assert is_fixed(tree / name) or (tree / name).read_text() == text
        assert (tree / name).read_text().endswith(text[-20:])
    killed = run.returncode == -9
    assert killed or all(is_fixed(tree / name) for name in old)
    assert fix(tree).code == 0
    assert all(is_fixed(tree / name) for name in old)


def without_capabilities(tree: Path) -> subprocess.CompletedProcess[str]:
    """A fix by an ordinary user, who owns what is not given away."""
    return subprocess.run(
        [
            *("setpriv", "--bounding-set=-all", "--inh-caps=-all", sys.executable, "-m", "bringup_lint"),
            *("--fix", "--unsafe-fixes", "--select", "systemd/network-target", "--output-format", "concise", "."),
        ],
        cwd=tree,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(PROJECT)},
    )


@as_root
def test_without_permission_there_is_a_message_and_a_report(tree: Path) -> None:
    os.chown(tree, 1234, 5678)
    run = without_capabilities(tree)
    assert run.returncode == 2
    assert "not written: a.service: Permission denied" in run.stderr
    assert "Traceback" not in run.stderr
    assert run.stdout.count("systemd/network-target") == 2


@as_root
def test_a_file_of_another_owner_is_not_taken_over(tree: Path) -> None:
    os.chown(tree / "a.service", 1234, 5678)
    run = without_capabilities(tree)
    assert run.returncode == 2
    assert "not written: a.service: its owner 1234:5678 would not stay" in run.stderr
    assert (tree / "a.service").stat().st_uid == 1234
    assert is_fixed(tree / "z.service")
    assert leftovers(tree) == []


FULL = """
import resource, signal, sys
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (100, resource.RLIM_INFINITY))
sys.argv[0] = "bringup-lint"
sys.dont_write_bytecode = True
from bringup_lint.__main__ import main
main()
"""


def test_a_full_disk_leaves_everything_as_it_was(tree: Path) -> None:
    run = subprocess.run(
        [
            sys.executable,
            "-c",
            FULL,
            "--fix",
            "--unsafe-fixes",
            "--output-format",
            "json",
            "--output-file",
            "r.json",
            ".",
        ],
        cwd=tree,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(PROJECT)},
    )
    assert run.returncode == 2
    assert "not written: a.service: File too large" in run.stderr
    assert "not written: r.json: File too large" in run.stderr
    assert "Traceback" not in run.stderr
    assert (tree / "a.service").read_text() == UNIT
    assert sorted(os.listdir(tree)) == ["a.service", "z.service"]


def test_an_interrupt_while_the_program_is_loaded_is_130(tree: Path) -> None:
    code = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler); "  # a shell's background ignores it
        "from bringup_lint import __main__ as it; it.main = lambda: signal.raise_signal(2); it.program()"
    )
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}
    run = subprocess.run([sys.executable, "-c", code], cwd=tree, capture_output=True, env=environment, check=False)
    assert (run.returncode, run.stderr) == (130, b"")
