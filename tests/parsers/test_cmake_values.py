"""What commands of CMake compute."""

from __future__ import annotations

import pytest

from bringup_lint.parsers import cmake
from bringup_lint.parsers import cmake_values
from bringup_lint.source import Source


@pytest.mark.parametrize(
    ("bounds", "expected"),
    [
        (["3"], ["0", "1", "2", "3"]),
        (["2", "4"], ["2", "3", "4"]),
        (["0", "5", "2"], ["0", "2", "4"]),
        (["4", "2"], None),
        (["0", "5", "0"], None),
        (["0", "5000"], None),
        (["last"], None),
        ([], None),
    ],
)
def test_the_numbers_of_a_loop_end_with_the_stop(bounds: list[str], expected: list[str] | None) -> None:
    assert cmake_values.numbers(bounds) == expected


@pytest.mark.parametrize(
    ("part", "expected"),
    [
        ("NAME", "drive.launch.py"),
        ("NAME_WE", "drive"),
        ("EXT", ".launch.py"),
        ("DIRECTORY", "a/b"),
        ("PATH", "a/b"),
        ("REALPATH", None),
    ],
)
def test_the_extension_is_the_longest_one(part: str, expected: str | None) -> None:
    assert cmake_values.part_of_path("a/b/drive.launch.py", part) == expected


def test_items_and_numbers() -> None:
    assert [cmake_values.element(["a", "b"], each) for each in ("1", "-2", "2", "x")] == ["b", "a", None, None]
    assert [cmake_values.number(each) for each in ("7 - 1", "2 * (3 + 4)", "1 << 2")] == ["6", "14", None]


def test_a_list_that_doubles_is_not_followed() -> None:
    lines = ["set(A one two)", *["set(A ${A} ${A})"] * 60, "install(PROGRAMS ${A} DESTINATION lib/kite)"]
    build = cmake.parse(Source("CMakeLists.txt", "\n".join(lines)), "kite")
    assert not build.executables
    assert not build.executables_known
