"""Everything that a run asks of the disk is recorded, and what is recorded decides whether an answer still holds."""

from __future__ import annotations

import ast
import glob
import io
import os
import shutil
import sys
import time
from collections.abc import Callable
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import HealthCheck
from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.cache import answers
from bringup_lint.cli import answering
from bringup_lint.discover import disk
from bringup_lint.discover import record
from tests.architecture.imports import PACKAGE
from tests.architecture.imports import nodes
from tests.architecture.imports import paths
from tests.architecture.test_disk import accesses
from tests.cache.running import Program
from tests.cache.running import entry
from tests.conftest import PROJECT

YOUNG = 12_000_000
"""Nanoseconds, for tests that wait until a file is old; the times of a file are those of a tick, of 10 ms at most."""
AGED = 0.013
OF_OS = ("stat", "lstat", "scandir", "listdir", "open", "readlink", "access")
DIRECT = {
    "discover/disk.py": "records what is asked",
    "discover/record.py": "asks once more",
    "discover/reading.py": "records what it reads",
    "discover/git_changes.py": "says that the run depends on more",
    "discover/kinds/__init__.py": "lists the modules of the package",
}


def asked_of(monkeypatch: pytest.MonkeyPatch) -> set[str]:
    """The absolute paths that are asked for from now on."""
    asked: set[str] = set()

    def watched(name: str, function: Callable[..., object]) -> Callable[..., object]:
        def call(path: object = ".", *words: object, **more: object) -> object:
            if isinstance(path, (str, os.PathLike)) and more.get("dir_fd") is None:
                asked.add(os.path.join(os.getcwd(), os.fspath(path)))
            return function(path, *words, **more)

        return call

    for name in OF_OS:
        monkeypatch.setattr(os, name, watched(name, getattr(os, name)))
    monkeypatch.setattr(io, "open", watched("open", io.open))
    monkeypatch.setattr("builtins.open", watched("open", open))
    return asked


@pytest.mark.parametrize(
    ("name", "arguments"),
    [("crosslayer", ()), ("guide", ("--root", ".")), ("good", ("--tracked",)), ("skiff", ("--changed", "etc"))],
)
def test_a_run_asks_nothing_that_is_not_recorded(
    program: Program, name: str, arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    tree = PROJECT / "fixtures/robots" / name / "tree"
    shutil.copytree(tree, program.tree, symlinks=True, dirs_exist_ok=True)
    (program.tree / ".git").mkdir()
    with monkeypatch.context() as patch:
        asked = asked_of(patch)
        program.run(*arguments)
    looks = {os.path.normpath(look[1]) for look in entry(program.entries[0])["seen"]}
    top = str(program.tree.parent)
    below = {path for path in map(os.path.normpath, asked) if path.startswith(top) and path != str(program.base)}
    assert {path for path in below - looks if not path.startswith(f"{program.base}/")} == set()
    assert len(below) > 10


@pytest.mark.parametrize("name", ["docker-compose.yml", "notes"])
def test_no_link_out_of_the_tree_is_followed_by_the_record(program: Program, name: str) -> None:
    (program.tree / ".git").mkdir()
    (program.tree / name).symlink_to("../outside/secret")
    program.run()
    assert not [look for look in entry(program.entries[0])["seen"] if "outside" in look[1]]


def test_a_folder_that_became_a_link_is_not_entered(program: Program, monkeypatch: pytest.MonkeyPatch) -> None:
    (program.tree / "etc/systemd/system").mkdir(parents=True)
    (program.tree / "etc/systemd/system/rover.service").write_text(UNITS[1])
    program.run()
    (program.tree / "etc").rename(program.tree.parent / "outside")
    (program.tree / "etc").symlink_to("../outside")
    (path,) = program.entries
    seen = entry(path)["seen"]
    with monkeypatch.context() as patch:
        asked = asked_of(patch)
        assert len(list(answers.Question([])._as_before(seen))) < len(seen)
    assert not [path for path in asked if "/etc/" in path.partition(str(program.tree))[2]]


def test_discovery_asks_the_disk_in_one_place() -> None:
    direct = (path for path in paths() if path.is_relative_to(PACKAGE / "discover") and any(accesses(path)))
    found = {str(path.relative_to(PACKAGE)) for path in direct if _asks(path)}
    assert found == DIRECT.keys()


def _asks(path: Path) -> bool:
    return bool({name for name in accesses(path) if name.startswith("os.")} or path.parent.name == "kinds")


def variables(path: Path) -> Iterator[str]:
    """The environment variables that a module reads by name."""
    if "environ" not in path.read_text("utf-8"):
        return
    for node in nodes(path):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "os.environ.get":
            yield ast.literal_eval(node.args[0]) if isinstance(node.args[0], ast.Constant) else path.name


OF_NO_ANSWER = {
    "streams of a report that is not kept": {"SOURCE_DATE_EPOCH", "automation.py", "TF_BUILD", "SYSTEM_COLLECTIONURI"},
    "of other commands": {"RMW_IMPLEMENTATION", "ROS_SECURITY_ENABLE", "ROS_DOMAIN_ID", "ROS_DISTRO"},
    "only when something failed": {"__init__.py"},
    "of the cache itself": {"HOME", "XDG_CACHE_HOME", "answering.py"},
}
OF_THE_TERMINAL = {"COLUMNS", "NO_COLOR", "FORCE_COLOR", "TERM"}


def test_every_variable_that_is_read_is_known_to_the_cache() -> None:
    read = {name for path in paths() for name in variables(path)}
    known = set[str]().union(*OF_NO_ANSWER.values(), OF_THE_TERMINAL, answering.VARIABLES)
    assert read <= known


NAMES = st.sampled_from(["a", "b", "ab", ".a", "a.b", "[", "ä"])


@given(
    st.sets(st.tuples(NAMES, NAMES), max_size=6),
    st.lists(st.sampled_from(["*", "a*", "?", ".*", "[ab]", "a", "**", "", "[", "*.b"]), min_size=1, max_size=3),
)
def test_patterns_match_as_glob_does(tmp_path_factory: pytest.TempPathFactory, files: set, parts: list[str]) -> None:
    top = tmp_path_factory.mktemp("glob")
    for folder, name in files:
        (top / folder).mkdir(exist_ok=True)
        (top / folder / name).touch()
    pattern = "/".join([glob.escape(str(top)), *parts])
    assert disk.matches(pattern) == bool(glob.glob(pattern))


UNITS = ("[Service]\nExecStart=/usr/bin/rover\n", "[Service]\nRestart=sometimes\n", "[Unit]\nAfter=b.service\n", "")
LAUNCH = '<launch><node pkg="rover" exec="drive"><param from="$(find-pkg-share rover)/a.yaml"/></node></launch>'
CONTENTS = st.sampled_from(
    (*UNITS, LAUNCH, "services:\n  a:\n    image: ros:latest\n", "a:\n  ros__parameters:\n    b: 1\n", "*.service\n")
)
PATHS = st.sampled_from(
    (
        "etc/systemd/system/a.service",
        "etc/systemd/system/b.service",
        "etc/systemd/system/a.service.d/x.conf",
        *("rover/launch/a.launch.xml", "rover/config/a.yaml", "rover/package.xml", "rover/COLCON_IGNORE"),
        *("docker-compose.yml", ".gitignore", "bringup-lint.toml", "notes.txt"),
        *("etc/os-release", "etc/passwd", "usr/bin/rover", ".git/HEAD"),
    )
)


def write(path: Path, content: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content)


def write_unseen(path: Path, content: str) -> None:
    status = path.stat() if path.exists() else None
    write(path, content)
    if status is not None:
        os.utime(path, ns=(status.st_atime_ns, status.st_mtime_ns))


def remove(path: Path, content: str) -> None:
    path.unlink(missing_ok=True)


def link(path: Path, content: str) -> None:
    remove(path, content)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.symlink_to("/dev/null" if content.startswith("[") else "b.service")


def close(path: Path, content: str) -> None:
    if path.exists() and not path.is_symlink():
        path.chmod(0o755 if content else 0o600)


def move(path: Path, content: str) -> None:
    if path.parent.is_dir() and path.parent.name:
        path.parent.rename(path.parent.with_name("elsewhere" if path.parent.name != "elsewhere" else "back"))


EDITS = st.tuples(st.sampled_from([write, write, write_unseen, remove, link, close, move]), PATHS, CONTENTS)


@pytest.mark.slow
@pytest.mark.parametrize("by", ["times", "content"])
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(before=st.lists(EDITS, min_size=2, max_size=8), edits=st.lists(EDITS, min_size=1, max_size=3))
def test_after_any_edit_the_answer_is_that_of_a_first_run(
    program: Program, by: str, before: list, edits: list, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(record, "YOUNG", YOUNG)
    shutil.rmtree(program.tree)
    program.tree.mkdir()
    os.chdir(program.tree)
    for edit, path, content in before:
        _apply(edit, path, content)
    for edit, path, content in [(remove, "nothing", ""), *edits]:
        time.sleep(AGED)
        _apply(edit, path, content)
        time.sleep(AGED)
        kept = program.run("--cache-by", by)
        assert kept.shown == program.run("--no-cache").shown
        again = program.run("--cache-by", by)
        assert again.shown == kept.shown
        assert again.is_answered or again.code > 1


def _apply(edit: Callable[[Path, str], None], path: str, content: str) -> None:
    try:
        edit(Path(path), content)
    except OSError:
        assert sys.exc_info()


def test_names_that_no_encoding_has(program: Program) -> None:
    folder = os.fsencode(program.tree) + b"/etc/systemd/system"
    os.makedirs(folder)
    with open(folder + b"/\xff.service", "w") as file:
        file.write(UNITS[1])
    first, second = program.run(), program.run()
    assert first.shown == second.shown


def test_the_start_of_a_file_that_is_read_whole_is_no_look_of_its_own(
    program: Program, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(record, "YOUNG", YOUNG)
    path = program.tree / "driver.yaml"
    path.write_text("driver:\n  ros__parameters:\n    port: 1\n")
    os.utime(path, (1, 1))
    time.sleep(AGED)
    program.run()
    looks = [look[0][0] for look in entry(program.entries[0])["seen"] if look[1] == str(path)]
    assert looks == [record.WHOLE]
    path.write_text("driver:\n  ros__parameters:\n    port: 2\n")
    assert not program.run().is_answered
