"""The folders of paths, however they are written."""

from __future__ import annotations

from bringup_lint.folders import above
from bringup_lint.folders import joined


def test_the_folders_above() -> None:
    assert list(above("/opt/robot/start.sh")) == ["/opt/robot", "/opt"]
    assert list(above("a/b/c")) == ["a/b", "a"]


def test_they_end_at_each_root() -> None:
    assert list(above("/start.sh")) == []
    assert list(above("//robot/start.sh")) == ["//robot"]
    assert list(above("///")) == []
    assert list(above("start.sh")) == []
    assert list(above("")) == []


def test_a_path_of_any_length_has_so_many() -> None:
    assert len(list(above("a/" * 10_000))) == 100


def test_two_slashes_are_one() -> None:
    assert joined("/", "//robot//start.sh") == "/robot/start.sh"
    assert joined("/ws", "../robot/./start.sh") == "/robot/start.sh"
    assert joined("robot", "start.sh") == "robot/start.sh"
