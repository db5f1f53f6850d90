"""Elements of list literals move with their comments, and every other byte stays."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from bringup_lint.codemods.lists import move_after
from bringup_lint.codemods.lists import move_before
from bringup_lint.codemods.lists import remove
from bringup_lint.finding import Codemod
from bringup_lint.source import Source
from bringup_lint.source import Span

DESCRIPTION = """\
# The launch file of the rover.
from launch import LaunchDescription

def generate_launch_description():
    return LaunchDescription([
        # what drives
        node(name),  # the base

        # the name of it
        declare('name'),   # needed
        other()
    ])  # end
"""
MOVED = """\
# The launch file of the rover.
from launch import LaunchDescription

def generate_launch_description():
    return LaunchDescription([

        # the name of it
        declare('name'),   # needed
        # what drives
        node(name),  # the base
        other()
    ])  # end
"""


def change(text: str, make: Callable[..., Codemod | None], *words: str) -> str:
    source = Source("robot.launch.py", text)
    codemod = make(*(Span(source, text.index(word), text.index(word) + len(word)) for word in words))
    return codemod.change(text) if codemod else "no"


def test_comments_move_with_their_element() -> None:
    assert change(DESCRIPTION, move_before, "declare", "node(") == MOVED


def test_line_ends_and_byte_order_mark_stay() -> None:
    before, after = (("\ufeff" + text).replace("\n", "\r\n") for text in (DESCRIPTION, MOVED))
    assert change(before, move_before, "declare", "node(") == after


def test_last_element_without_a_comma_moves() -> None:
    assert change("x = [\n    a,\n    b  # last\n]\n", move_before, "b ", "a,") == "x = [\n    b,  # last\n    a\n]\n"


@pytest.mark.parametrize(
    ("make", "words", "after"),
    [
        (move_after, ("'amcl'", "'map'"), "names = ['map', 'amcl', 'é']\n"),
        (move_after, ("'map'", "'amcl'"), "names = ['amcl', 'map', 'é']\n"),
        (move_before, ("'é'", "'amcl'"), "names = ['é', 'amcl', 'map']\n"),
        (remove, ("'é'",), "names = ['amcl', 'map']\n"),
        (remove, ("'amcl'",), "names = ['map', 'é']\n"),
    ],
)
def test_one_line(make: Callable[..., Codemod | None], words: tuple[str, ...], after: str) -> None:
    assert change("names = ['amcl', 'map', 'é']\n", make, *words) == after


def test_comma_after_the_last_element_stays() -> None:
    assert (
        change("x = [\n    a,  # a\n    b,  # b\n]\n", move_before, "b, ", "a,")
        == "x = [\n    b,  # b\n    a,  # a\n]\n"
    )


def test_removed_element_takes_its_comments_along() -> None:
    assert change("x = [\n    a,\n    # why b\n    b,  # b\n    c,\n]\n", remove, "b, ") == "x = [\n    a,\n    c,\n]\n"


@pytest.mark.parametrize("text", ["f(a, b)\n", "x = [a]\ny = [b]\n", "x = [a + b]\n", "x = [a, b\n"])
def test_what_shares_no_list_is_left_alone(text: str) -> None:
    assert change(text, move_before, "b", "a") == "no"
