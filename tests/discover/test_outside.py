"""What lies outside of the tree is not read, not followed and not looked for."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from shutil import which

import pytest

from bringup_lint.discover.git_index import UnknownFormat
from bringup_lint.discover.git_index import index_of
from bringup_lint.discover.git_index import tracked_paths
from bringup_lint.discover.tree import Tree
from tests.conftest import PROJECT
from tests.lint import Run
from tests.lint import lint

SECRET = b"[Service]\nExecStart=/bin/\xff\n"


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    folder = tmp_path / "checkout"
    folder.mkdir()
    (tmp_path / "host.service").write_bytes(SECRET)
    (tmp_path / "host").mkdir()
    (tmp_path / "host/host.service").write_bytes(SECRET)
    return folder


def concise(*arguments: str | Path, cwd: Path) -> Run:
    return lint("--select", "lint", "--output-format", "concise", *arguments, cwd=cwd)


@pytest.mark.parametrize("repository", [True, False])
@pytest.mark.parametrize("target", ["../host.service", "../host"])
def test_a_named_link_is_not_followed_out_of_the_tree(tree: Path, target: str, repository: bool) -> None:
    if repository:
        subprocess.run(["git", "init", "-q"], cwd=tree, check=True)
    (tree / "robot.service").symlink_to(target)
    run = concise("robot.service", cwd=tree)
    assert run.code == 1
    assert run.stdout == (
        "robot.service:1:1: error[lint/unreadable] Not checked: a symbolic link leads out of the tree; name the place"
        " that it leads to\n"
    )


def test_a_named_file_in_a_linked_folder_is_not_read(tree: Path) -> None:
    (tree / "linked").symlink_to("../host")
    assert "lint/unreadable" in concise("linked/host.service", cwd=tree).stdout


def test_a_named_link_is_followed_inside_the_tree(tree: Path) -> None:
    (tree / "real.service").write_bytes(SECRET)
    (tree / "robot.txt").symlink_to("real.service")
    assert concise("robot.txt", cwd=tree).stdout.startswith("real.service:1:1: error[lint/encoding]")


def test_a_link_of_an_image_leads_where_it_leads_on_the_robot(tree: Path) -> None:
    (tree / "etc").mkdir()
    (tree / "opt").mkdir()
    (tree / "opt/robot.service").write_bytes(SECRET)
    (tree / "etc/robot.conf").symlink_to("/opt/robot.service")
    (tree / "etc/host.conf").symlink_to(tree.parent / "host.service")
    assert "opt/robot.service:1:1: error[lint/encoding]" in concise("--root", ".", "/etc/robot.conf", cwd=tree).stdout
    assert "lint/unreadable" in concise("--root", ".", "/etc/host.conf", cwd=tree).stdout


def test_nobody_looks_for_what_lies_outside(tree: Path) -> None:
    (tree / "linked").symlink_to("../host")
    (tree / "gone").symlink_to("nowhere")
    (tree / "out").symlink_to("../nowhere")
    (tree / "file").touch()
    checkout = Tree(tops=(str(tree),))
    there = [checkout.exists(str(tree / name)) for name in ("file", "absent", "../absent", "linked/absent")]
    assert there == [True, False, True, True]
    assert [checkout.is_file(str(tree / name)) for name in ("file", "../host.service", "linked/host.service")] == [
        *(True, False, False)
    ]
    assert [checkout.is_broken(str(tree / name)) for name in ("gone", "out")] == [True, False]


LIBRARY = """<package format="3">
  <name>rover</name><version>0.0.1</version><description>Rover</description>
  <maintainer email="a@b.c">a</maintainer><license>MIT</license>
</package>
"""


@pytest.mark.parametrize("folder", ["", "../"])
def test_a_library_of_parameters_outside_is_not_read(tree: Path, folder: str) -> None:
    names = [f"speed_{letter}" for letter in "abc"]
    listed = "".join(f"  {name}:\n    type: double\n" for name in names)
    (tree / f"{folder}rover.yaml").write_text(f"rover:\n{listed}")
    given = "".join(f"    {name}: 1.0\n" for name in (*names, "wheels"))
    (tree / "config.yaml").write_text(f"rover:\n  ros__parameters:\n{given}")
    (tree / "CMakeLists.txt").write_text(f"project(rover)\ngenerate_parameter_library(made {folder}rover.yaml)\n")
    (tree / "package.xml").write_text(LIBRARY)
    found = lint("--select", "params/not-declared", "--output-format", "concise", ".", cwd=tree).stdout
    assert ("wheels" in found) == (not folder)


def test_a_git_directory_elsewhere_is_not_read(tree: Path) -> None:
    elsewhere = tree.parent / "elsewhere"
    elsewhere.mkdir()
    (tree / ".git").write_text("gitdir: ../elsewhere\n")
    assert index_of(str(tree)) is None
    (elsewhere / "gitdir").write_text(f"{tree}/.git\n")
    assert index_of(str(tree)) == str(elsewhere / "index")


def test_worktrees_and_submodules_have_their_index(tree: Path) -> None:
    def git(*words: str, cwd: Path = tree) -> None:
        identity = ("-c", "user.name=a", "-c", "user.email=a@b", "-c", "protocol.file.allow=always")
        subprocess.run(["git", *identity, *words], cwd=cwd, check=True, capture_output=True)

    git("init", "-q")
    git("commit", "-q", "--allow-empty", "-m", "x")
    git("worktree", "add", "-q", "../second")
    git("submodule", "add", "-q", str(tree), "inner")
    assert str(index_of(str(tree.parent / "second"))).endswith(".git/worktrees/second/index")
    assert str(index_of(str(tree / "inner"))).endswith(".git/modules/inner/index")


@pytest.mark.parametrize("kind", ["fifo", "link"])
def test_the_index_is_a_bounded_file(tree: Path, kind: str) -> None:
    (tree / ".git").mkdir()
    index = tree / ".git/index"
    os.mkfifo(index) if kind == "fifo" else index.symlink_to("/dev/zero")
    (tree / "enclaves/a").mkdir(parents=True)
    (tree / "enclaves/a/key.pem").write_text("-----BEGIN PRIVATE KEY-----\nMIG\n-----END PRIVATE KEY-----\n")
    (tree / "enclaves/a/cert.pem").write_text("x")
    assert lint(".", cwd=tree).code in (0, 1)


def test_an_index_does_not_grow_without_bound() -> None:
    """Version 4 leaves out what a path shares with the one before."""
    entry = bytes(40 + 20) + (0xFFF).to_bytes(2, "big")
    data = b"DIRC" + (4).to_bytes(4, "big") + (50_000).to_bytes(4, "big")
    data += entry + b"\0" + b"a" * 4096 + b"\0" + (entry + b"\x01b\0") * 49_999
    with pytest.raises(UnknownFormat):
        tracked_paths(data)


def test_an_ignore_file_is_a_bounded_file(tree: Path) -> None:
    os.mkfifo(tree / ".gitignore")
    assert not Tree.is_ignored(str(tree / "x"))
    (tree / ".gitignore").unlink()
    (tree / ".gitignore").write_text("*a" * 40 + "b\n")
    assert not Tree.is_ignored(str(tree / ("a" * 250)))


@pytest.mark.skipif(os.geteuid() != 0 or not which("setpriv"), reason="only root makes files that a user cannot read")
def test_what_a_user_may_not_read_of_a_system_is_one_note(tree: Path) -> None:
    for name in ("etc/passwd", "etc/os-release", "etc/netplan/a.yaml", "etc/polkit/b.rules", "usr/x"):
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        (tree / name).touch()
    for name in ("etc/netplan/a.yaml", "etc/polkit"):
        os.chown(tree / name, 1234, 1234)
        (tree / name).chmod(0)
    (tree / "etc/robot.service").write_text("[Service]\nExecStart=/bin/true\n")
    words = ["setpriv", "--bounding-set=-all", "--inh-caps=-all", sys.executable, "-m", "bringup_lint"]
    environment = {**os.environ, "PYTHONPATH": str(PROJECT)}

    def check(*arguments: str) -> subprocess.CompletedProcess[str]:
        command = [*words, "--select", "lint", "--output-format", "concise", *arguments]
        return subprocess.run(command, cwd=tree, capture_output=True, text=True, env=environment)

    run = check("etc")
    assert (run.returncode, run.stdout) == (0, "")
    assert run.stderr == (
        "bringup-lint: Not checked, because this user may not read it: etc/netplan/a.yaml and 1 more. Run it with"
        " sudo.\n"
    )
    run = check("etc/netplan/a.yaml")
    assert (run.returncode, run.stdout.count("lint/unreadable")) == (1, 1), run.stderr


def a_root(folder: Path) -> Path:
    for name in ("etc/netplan", "usr/lib"):
        (folder / name).mkdir(parents=True)
    (folder / "usr/lib/os-release").write_text("ID=ubuntu\n")
    (folder / "etc/passwd").write_text("root:x:0:0:root:/root:/bin/bash\n")
    plan = folder / "etc/netplan/60-robot.yaml"
    plan.write_text("network:\n  ethernets:\n    eth0: {dhcp4: true}\n")
    plan.chmod(0o644)
    return folder


def modes(*arguments: str, cwd: Path) -> int:
    return lint("--select", "netplan/file-mode", "--output-format", "concise", *arguments, cwd=cwd).stdout.count("\n")


@pytest.mark.parametrize(("repository", "told"), [("", 1), (".", 0), ("..", 0), ("etc", 1)])
def test_modes_of_a_checkout_are_not_judged(tmp_path: Path, repository: str, told: int) -> None:
    """git keeps no 0600: only a root that lies in no repository, or that is named, has the modes of the robot."""
    root = a_root(tmp_path / "checkout" / "root")
    if repository:
        top = root / repository
        subprocess.run(["git", "init", "-q"], cwd=top, check=True)
        subprocess.run(["git", "add", "-f", "."], cwd=top, check=True)
    assert modes(".", cwd=root) == told
    assert modes("--root", ".", cwd=root) == 1


def test_a_root_is_recognized_without_a_look_outside(tmp_path: Path) -> None:
    from bringup_lint.discover.roots import is_root

    root = a_root(tmp_path / "root")
    assert is_root(str(root))
    (root / "etc/passwd").unlink()
    (root / "etc/passwd").symlink_to(tmp_path / "passwd")
    (tmp_path / "passwd").write_text("root:x:0:0:root:/root:/bin/bash\n")
    assert not is_root(str(root))


def test_a_real_path_stays_in_the_tree(tree: Path) -> None:
    (tree / "in").symlink_to("real.yaml")
    (tree / "real.yaml").write_text("")
    (tree / "out").symlink_to("../host.service")
    found = Tree(tops=(str(tree),))
    assert found.real_path(str(tree / "in")) == str(tree / "real.yaml")
    assert found.real_path(str(tree / "out")) == str(tree / "out")
    assert found.real_path("/etc/localtime") == "/etc/localtime"
