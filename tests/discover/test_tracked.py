"""Which files go with a repository: what its index lists, in every version of the format."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from bringup_lint.discover.git_index import UnknownFormat
from bringup_lint.discover.git_index import index_of
from bringup_lint.discover.git_index import tracked_paths
from bringup_lint.discover.tree import Tree
from tests.lint import lint

KEY = "-----BEGIN PRIVATE KEY-----\nMIG\n-----END PRIVATE KEY-----\n"


def git(folder: Path, *words: str) -> str:
    run = subprocess.run(["git", "-C", str(folder), *words], capture_output=True, text=True, check=True)
    return run.stdout


def repository(folder: Path, *paths: str) -> None:
    """A repository whose index lists exactly these files."""
    git(folder, "init", "--quiet")
    for path in paths:
        file = folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(KEY)
    git(folder, "add", "--force", *paths)


PATHS = (
    "a/keystore/private/ca.key.pem",
    "a/keystore/private/other.pem",
    "ab",
    "b" * 200 + "/" + "c" * 4,
    "ä/ö.pem",
    "x" * 62,
    "y" * 63,
    "z" * 64,
    "z" * 65,
)


@pytest.mark.parametrize("version", [2, 3, 4])
def test_every_version_of_the_index(tmp_path: Path, version: int) -> None:
    repository(tmp_path, *PATHS)
    if version == 3:
        (tmp_path / "new").write_text("")
        git(tmp_path, "add", "--intent-to-add", "new")
    else:
        git(tmp_path, "update-index", "--index-version", str(version))
    data = (tmp_path / ".git/index").read_bytes()
    assert int.from_bytes(data[4:8], "big") == version
    listed = git(tmp_path, "ls-files", "-z").rstrip("\0").split("\0")
    assert sorted(tracked_paths(data)) == sorted(path.encode() for path in listed)


def test_a_sha256_repository(tmp_path: Path) -> None:
    git(tmp_path, "init", "--quiet", "--object-format=sha256")
    repository(tmp_path, *PATHS)
    assert sorted(tracked_paths((tmp_path / ".git/index").read_bytes())) == sorted(path.encode() for path in PATHS)


@pytest.mark.parametrize("cut", range(0, 400, 7))
def test_a_damaged_index_is_not_read(tmp_path: Path, cut: int) -> None:
    repository(tmp_path, *PATHS)
    data = (tmp_path / ".git/index").read_bytes()
    with pytest.raises(UnknownFormat):
        tracked_paths(data[:cut])


def test_a_split_index_lists_only_part(tmp_path: Path) -> None:
    repository(tmp_path, *PATHS)
    git(tmp_path, "update-index", "--split-index")
    with pytest.raises(UnknownFormat):
        tracked_paths((tmp_path / ".git/index").read_bytes())
    assert Tree().tracked(str(tmp_path / "ab")) is False


def test_a_worktree_has_an_index_of_its_own(tmp_path: Path) -> None:
    (tmp_path / "main").mkdir()
    repository(tmp_path / "main", "keys/ca.key.pem")
    git(tmp_path / "main", "-c", "user.name=a", "-c", "user.email=a@b.c", "commit", "--quiet", "-m", "keys")
    git(tmp_path / "main", "worktree", "add", "--quiet", str(tmp_path / "other"))
    assert Tree().tracked(str(tmp_path / "other/keys/ca.key.pem")) is True
    assert Tree().tracked(str(tmp_path / "other/keys/none.pem")) is False


def test_without_git_nobody_tells(tmp_path: Path) -> None:
    assert Tree().tracked(str(tmp_path / "ca.key.pem")) is None


def test_a_repository_to_which_nothing_was_added_does_not_tell(tmp_path: Path) -> None:
    git(tmp_path, "init", "--quiet")
    assert Tree().tracked(str(tmp_path / "ca.key.pem")) is None


@pytest.mark.parametrize("version", ["2", "4"])
def test_a_key_is_committed_by_its_whole_path(tmp_path: Path, version: str) -> None:
    """``keystore/private/ca.key.pem`` is the end of the path that is committed, and is not committed itself."""
    repository(tmp_path, "a/keystore/private/ca.key.pem")
    git(tmp_path, "update-index", "--index-version", version)
    untracked = tmp_path / "keystore/private/ca.key.pem"
    untracked.parent.mkdir(parents=True)
    untracked.write_text(KEY)
    (tmp_path / "robot.service").write_text("[Service]\nExecStart=/bin/true\n")
    run = lint("--select", "sros2/keystore-committed", "--output-format", "concise", ".", cwd=tmp_path)
    assert [line.partition(":")[0] for line in run.stdout.splitlines() if ": error[" in line] == [
        "a/keystore/private/ca.key.pem"
    ]


def test_a_folder_is_asked_once_for_its_repository(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    repository(tmp_path, "a/b/one.pem", "a/b/two.pem", "a/three.pem")
    (tmp_path / "a/inner").mkdir()
    repository(tmp_path / "a/inner", "four.pem")
    asked = []

    def counted(folder: str) -> str | None:
        asked.append(folder)
        return index_of(folder)

    monkeypatch.setattr("bringup_lint.discover.tree.index_of", counted)
    tree = Tree()
    paths = ("a/b/one.pem", "a/b/two.pem", "a/three.pem", "a/b/no.pem", "a/inner/four.pem", "a/inner/c/no.pem")
    assert [tree.tracked(str(tmp_path / path)) for path in paths] == [True, True, True, False, True, False]
    assert len(asked) == len(set(asked))
    assert tree.tracked("/" + "x/" * 1_500 + "y") is None
