"""Patterns as git reads them, in linear time."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from hypothesis import example
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.discover.gitignore import PatternError
from bringup_lint.discover.gitignore import Patterns
from bringup_lint.discover.gitignore import pattern_of
from tests.growth import is_linear

PATTERNS = [
    *("a", "a/", "/a", "*.c", "a*", "*a*b", "?", "a?c", "[ab]", "[!a]", "[a-c]x", "\\a", "\\#a", "\\!a", "#a", ""),
    *("a/b", "a/*", "*/b", "**/b", "a/**", "a/**/b", "**", "**/a/b", "/**/b", "a/**/c/**", "a**b", "a ", "a\\ "),
    *("!a", "!*.c", "!a/b", "[", "[a", "a\\", "[]a]", "[!]a]", "[a-]", "[[:digit:]]", "[\\]]", "/", "//", "a//b"),
]
NAMES = ["a", "b", "c", "x.c", "ax", "aab", "abc", "#a", "!a", "a ", "1", "]", "-"]


@pytest.fixture(scope="session")
def repository(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("repository")
    subprocess.run(["git", "init", "-q"], cwd=folder, check=True)
    return folder


def by_git(repository: Path, patterns: list[str], paths: list[str]) -> dict[str, bool]:
    (repository / ".gitignore").write_text("\n".join(patterns) + "\n")
    run = subprocess.run(
        ["git", "check-ignore", "--no-index", "-z", "--stdin"],
        cwd=repository,
        input="\0".join(paths) + "\0",
        capture_output=True,
        text=True,
    )
    found = set(run.stdout.split("\0"))
    return {path: path in found for path in paths}


def paths_of(names: st.SearchStrategy[str]) -> st.SearchStrategy[list[str]]:
    path = st.lists(names, min_size=1, max_size=4).map("/".join)
    return st.lists(path, min_size=1, max_size=12, unique=True)


@given(st.lists(st.sampled_from(PATTERNS), min_size=1, max_size=4), paths_of(st.sampled_from(NAMES)))
def test_git_agrees(repository: Path, patterns: list[str], paths: list[str]) -> None:
    ours = Patterns.of(patterns)
    assert {path: ours.match(path) for path in paths} == by_git(repository, patterns, paths)


@example("[!/]", ["a", "ab", "b/a"])
@example("?//", ["a/a"])
@example("a/[/b]", ["a/b", "a/a"])
@given(st.text("ab*?[]!\\/^-#. ", max_size=12), paths_of(st.text("ab", min_size=1, max_size=5)))
def test_git_agrees_on_any_pattern(repository: Path, pattern: str, paths: list[str]) -> None:
    ours = Patterns.of([pattern])
    assert {path: ours.match(path) for path in paths} == by_git(repository, [pattern], paths)


def test_folders() -> None:
    patterns = Patterns.of(["build/", "!build/keep"])
    assert patterns.match("build/")
    assert not patterns.match("build")
    assert patterns.match("src/build/keep")


@pytest.mark.parametrize("pattern", ["[", "a\\", "[[:nothing:]]", "/"])
def test_what_is_no_pattern(pattern: str) -> None:
    with pytest.raises(PatternError):
        pattern_of(pattern)


@pytest.mark.parametrize(
    ("pattern", "path"),
    [("*a" * 100 + "b", "a"), ("**/a/" * 100 + "b", "a/"), ("*" * 5_000, "a")],
)
def test_time_is_linear_in_the_path(pattern: str, path: str) -> None:
    assert is_linear(lambda size: Patterns.of([pattern]).match(path * size), 300)


@pytest.mark.parametrize(("pattern", "path"), [("*a", "a" * 2_000), ("**/a/", "a/" * 100), ("*", "a" * 99)])
def test_time_is_linear_in_the_pattern(pattern: str, path: str) -> None:
    assert is_linear(lambda size: Patterns.of([pattern * size + "b"]).match(path), 12)
