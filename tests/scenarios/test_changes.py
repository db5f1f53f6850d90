"""``--since`` and ``--changed``: what a change touches, or reaches over the graph, and nothing else."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import PROJECT
from tests.lint import Run
from tests.lint import lint

NETPLAN = "etc/netplan/10-mower.yaml"
DDS = "etc/mower/dds.xml"
UNIT = "etc/systemd/system/mower.service"
ENV = "etc/mower/ros.env"


def git(folder: Path, *words: str) -> str:
    name = ("-c", "user.name=t", "-c", "user.email=t@example.org", "-c", "protocol.file.allow=always")
    return subprocess.run(["git", *name, *words], cwd=folder, capture_output=True, text=True, check=True).stdout


def commit(folder: Path, message: str = "change") -> None:
    git(folder, "add", "-A")
    git(folder, "commit", "-qm", message)


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """The example, whose findings are all in the first commit of its repository."""
    pytest.importorskip("dulwich")
    folder = tmp_path / "robot"
    shutil.copytree(PROJECT / "docs/example", folder)
    (folder / DDS).write_text((folder / DDS).read_text().replace("enp1s0", "enp2s0"))
    git(folder, "init", "-q", "-b", "main")
    commit(folder, "first")
    return folder


def since(folder: Path, revision: str = "main", *options: str) -> Run:
    return lint("--isolated", "--output-format", "concise", "--since", revision, *options, ".", cwd=folder)


def found(run: Run) -> set[tuple[str, str]]:
    """The files and rules of the findings."""
    assert run.code in (0, 1), run.stderr
    return {(line.partition(":")[0], line.partition("[")[2].partition("]")[0]) for line in run.stdout.splitlines()}


def replace(file: Path, old: str, new: str) -> None:
    text = file.read_text()
    assert old in text
    file.write_text(text.replace(old, new))


def test_nothing_changed(robot: Path) -> None:
    assert lint("--isolated", ".", cwd=robot).code == 1
    assert found(since(robot)) == set()


def test_a_change_elsewhere_is_nobodys_fault(robot: Path) -> None:
    (robot / "a.py").write_text("print('hello')\n")
    assert found(since(robot)) == set()


@pytest.mark.parametrize("state", ["committed", "staged", "edited"])
def test_an_edited_netplan_file_shows_the_dds_file_that_it_breaks(robot: Path, state: str) -> None:
    git(robot, "checkout", "-qb", "topic")
    replace(robot / NETPLAN, "enp2s0", "enp9s0")
    if state != "edited":
        git(robot, "add", "-A")
    if state == "committed":
        git(robot, "commit", "-qm", "rename the interface")
    shown = found(since(robot))
    assert (DDS, "cyclonedds/interface-not-in-netplan") in shown
    assert UNIT not in {path for path, _ in shown}


def test_a_deleted_file_shows_who_misses_it(robot: Path) -> None:
    git(robot, "rm", "-q", ENV)
    everything = found(lint("--isolated", "--output-format", "concise", ".", cwd=robot))
    shown = found(since(robot))
    assert shown <= everything
    assert (UNIT, "systemd/network-target") not in shown


def test_a_renamed_file_is_new(robot: Path) -> None:
    git(robot, "mv", UNIT, "etc/systemd/system/cutter.service")
    assert {path for path, _ in found(since(robot))} >= {"etc/systemd/system/cutter.service"}


def test_what_others_did_since_is_not_ours(robot: Path) -> None:
    """The comparison is with the merge base, not with the tip of the other branch."""
    git(robot, "checkout", "-qb", "topic")
    (robot / "notes.txt").write_text("one\n")
    commit(robot)
    git(robot, "checkout", "-q", "main")
    replace(robot / UNIT, "[Unit]", "[Unit]\n# moved on")
    commit(robot)
    git(robot, "checkout", "-q", "topic")
    assert found(since(robot)) == set()


def test_packed_refs_and_objects(robot: Path) -> None:
    git(robot, "tag", "-a", "v1", "-m", "one")
    git(robot, "checkout", "-qb", "topic")
    replace(robot / UNIT, "[Unit]", "[Unit]\n# touched")
    commit(robot)
    git(robot, "gc", "-q", "--aggressive")
    git(robot, "pack-refs", "--all")
    assert not list((robot / ".git/refs").rglob("v1"))
    shown = found(since(robot))
    assert (UNIT, "systemd/network-target") in shown
    for revision in ("v1", "HEAD~1", git(robot, "rev-parse", "main").strip(), git(robot, "rev-parse", "main")[:8]):
        assert found(since(robot, revision)) == shown


def test_line_ends_of_the_checkout_are_no_change(robot: Path) -> None:
    for name in (UNIT, DDS, NETPLAN):
        (robot / name).write_bytes((robot / name).read_bytes().replace(b"\n", b"\r\n"))
    assert UNIT not in {path for path, rule in found(since(robot))}


def test_a_shallow_clone_says_what_it_lacks(robot: Path, tmp_path: Path) -> None:
    replace(robot / UNIT, "[Unit]", "[Unit]\n# touched")
    commit(robot)
    git(tmp_path, "clone", "-q", "--depth", "1", f"file://{robot}", "shallow")
    run = since(tmp_path / "shallow", "HEAD~1")
    assert (run.code, run.stdout) == (2, "")
    assert "no commit is called 'HEAD~1' here; a shallow clone may lack it" in run.stderr
    assert found(since(tmp_path / "shallow", "HEAD")) == set()


def test_histories_that_do_not_meet(robot: Path) -> None:
    git(robot, "checkout", "-q", "--orphan", "other")
    replace(robot / UNIT, "[Unit]", "[Unit]\n# touched")
    commit(robot)
    run = since(robot)
    assert "no common commit with main is here" in run.stderr
    assert {path for path, _ in found(run)} == {UNIT, ENV}


def test_a_submodule_is_compared_with_its_own_commit(robot: Path, tmp_path: Path) -> None:
    outer = tmp_path / "outer"
    outer.mkdir()
    git(outer, "init", "-q", "-b", "main")
    git(outer, "submodule", "add", "-q", str(robot), "robots/mower")
    commit(outer)
    assert found(since(outer)) == set()
    replace(outer / "robots/mower" / UNIT, "[Unit]", "[Unit]\n# touched")
    assert {path for path, _ in found(since(outer))} == {f"robots/mower/{UNIT}", f"robots/mower/{ENV}"}


def test_nothing_of_the_tree_is_run(robot: Path, tmp_path: Path) -> None:
    """Whatever the settings of the repository name as a program."""
    proof = tmp_path / "ran"
    program = tmp_path / "program"
    program.write_text(f"#!/bin/sh\ntouch {proof}\n")
    program.chmod(0o755)
    for setting in ("core.fsmonitor", "core.sshCommand", "filter.x.smudge", "filter.x.clean", "diff.x.textconv"):
        git(robot, "config", setting, str(program))
    git(robot, "config", "core.hooksPath", str(tmp_path))
    shutil.copy(program, tmp_path / "post-checkout")
    (robot / ".gitattributes").write_text("* filter=x diff=x\n")
    replace(robot / UNIT, "[Unit]", "[Unit]\n# touched")
    assert since(robot).code == 1
    assert not proof.exists()


@pytest.mark.parametrize("revision", ["nothere", "deadbeef", "HEAD:a", "--all", "main..HEAD", "@{1}"])
def test_an_unknown_revision_is_one_line(robot: Path, revision: str) -> None:
    run = since(robot, revision)
    assert run.code == 2 and run.stderr.count("\n") == 1, run.stderr


@pytest.mark.parametrize("damage", ["objects", "HEAD", "config"])
def test_a_damaged_repository_is_one_line(robot: Path, damage: str) -> None:
    for file in [robot / ".git" / damage, *(robot / ".git" / damage).rglob("*")]:
        if file.is_file():
            file.chmod(0o644)
            file.write_bytes(b"\x78\x9c\xff\x00damaged")
    run = since(robot)
    assert run.code == 2 and run.stderr.count("\n") == 1, run.stderr


def test_outside_of_a_repository(tmp_path: Path) -> None:
    run = since(tmp_path)
    assert run.code == 2 and "lies in no git repository" in run.stderr


def changed(folder: Path, *files: str) -> set[tuple[str, str]]:
    return found(lint("--isolated", "--output-format", "concise", "--changed", *files, cwd=folder))


def test_changed_files_have_their_context(robot: Path) -> None:
    replace(robot / NETPLAN, "enp2s0", "enp9s0")
    (robot / "a.py").write_text("print('hello')\n")
    assert (DDS, "cyclonedds/interface-not-in-netplan") in changed(robot, NETPLAN)
    assert changed(robot, "a.py") == set()
    assert {path for path, _ in changed(robot, UNIT)} == {UNIT, ENV, DDS}, "the unit loads them"


def test_a_deleted_file_may_be_named(robot: Path) -> None:
    (robot / ENV).unlink()
    assert (UNIT, "systemd/network-target") not in changed(robot, ENV)


@pytest.mark.parametrize(
    "options", [("--changed",), ("--changed", "--root", ".", "a"), ("--since", "x", "--root", ".")]
)
def test_options_without_effect(robot: Path, options: tuple[str, ...]) -> None:
    assert lint(*options, cwd=robot).code == 2


def test_what_is_left_out_is_counted(robot: Path) -> None:
    everything = found(lint("--isolated", "--output-format", "concise", ".", cwd=robot))
    run = lint("--isolated", "--since", "main", ".", cwd=robot)
    assert run.code == 0
    assert run.stdout.startswith("Nothing to report of the change: 6 files checked\n")
    assert f"{len(everything)} more in which the change has no part" in run.stdout
