"""Code frames, one trait at a time."""

from __future__ import annotations

import pytest

from bringup_lint.report.frame import Mark
from bringup_lint.report.frame import draw
from bringup_lint.report.frame import frames
from bringup_lint.report.paint import painter
from bringup_lint.source import Source

PLAIN = painter(False)


def drawn(text: str, *marks: tuple[int, int, str], width: int = 40) -> str:
    """The frame of a file whose first mark is the main one."""
    source = Source("robot.conf", text)
    styles = ["error", *["mark"] * len(marks)]
    (frame,) = frames(
        Mark(source.span(start, end), style, label) for (start, end, label), style in zip(marks, styles, strict=False)
    )
    return "\n".join(draw(frame, 2, width, PLAIN))


def frame(picture: str) -> str:
    """A picture without the line ends and the indent that the test gives it."""
    return "\n".join(line[4:] for line in picture.strip("\n").splitlines()).rstrip(" ")


CASES = {
    "insertion": (
        "one\ntwo\n",
        [(4, 4, "")],
        """
       |
     1 | one
     2 | two
       | ^
""",
    ),
    "after the last character": (
        "one",
        [(3, 3, "")],
        """
       |
     1 | one
       |    ^
""",
    ),
    "labels beside each other": (
        "one two three",
        [(0, 3, ""), (4, 7, "second"), (8, 13, "third")],
        """
       |
     1 | one two three
       | ^^^ --- ----- third
       |     second
""",
    ),
    "same place twice": (
        "one two",
        [(0, 3, ""), (0, 3, "again")],
        """
       |
     1 | one two
       | ^^^
       | --- again
""",
    ),
    "lines far apart": (
        "a\nb\nc\nd\ne\nf\n",
        [(0, 1, ""), (10, 11, "far")],
        """
       |
     1 | a
       | ^
     2 | b
    ...
     6 | f
       | - far
""",
    ),
    "tall stretch": (
        "a\nb\nc\nd\ne\nf\ng\nh\n",
        [(0, 15, "")],
        """
       |
     1 | / a
     2 | | b
    ...  |
     8 | | h
       | |_^
""",
    ),
    "stretch with its line end": (
        "ab\ncd\n",
        [(0, 3, "")],
        """
       |
     1 | ab
       | ^^
     2 | cd
""",
    ),
    "mark inside a stretch": (
        "ab\ncd\nef\n",
        [(0, 8, ""), (3, 5, "inner")],
        """
       |
     1 | / ab
     2 | | cd
       | | -- inner
     3 | | ef
       | |__^
""",
    ),
    "stretches that overlap": (
        "ab\ncd\nef\n",
        [(0, 5, ""), (3, 8, "later")],
        """
       |
     1 | / ab
     2 | | cd
       | | -- later
       | |__^
     3 |   ef
""",
    ),
    "tabs": (
        "\tkey\tvalue",
        [(5, 10, "here")],
        """
       |
     1 |     key value
       |         ^^^^^ here
""",
    ),
    "wide and combining characters": (
        "名=e\u0301=x",
        [(5, 6, "here")],
        """
       |
     1 | 名=e\u0301=x
       |      ^ here
""",
    ),
    "control characters": (
        "a\x1b[0mb\x7f\u202ec",
        [(8, 9, "")],
        """
       |
     1 | a␛[0mb␡\ufffdc
       |         ^
""",
    ),
    "long line": (
        "x" * 500 + "HERE" + "y" * 500,
        [(500, 504, "")],
        """
       |
     1 | …xxxxxxxxHERE" + "yyyyyyyyyyyyyyyyyyyyy…
       |          ^^^^
""".replace('" + "', ""),
    ),
    "marks at both ends of a long line": (
        "A" + "." * 200 + "B",
        [(0, 1, ""), (201, 202, "end")],
        """
       |
     1 | A.................................…
       | ^
     1 | ….................................B
       |                                   -
       |                                 end
""",
    ),
    "windows line ends": (
        "one\r\ntwo\r\n",
        [(0, 5, "")],
        """
       |
     1 | one
       | ^^^
     2 | two
""",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_frame(name: str) -> None:
    text, marks, picture = CASES[name]
    assert drawn(text, *marks) == frame(picture).rstrip("\n")


def test_label_goes_below_when_there_is_no_room() -> None:
    text = drawn("x" * 30 + "END", (30, 33, "a label that is longer than what is left"), width=60)
    assert text.splitlines()[2:] == [
        "   | " + " " * 30 + "^^^",
        "   | " + " " * 19 + "a label that is longer than what is",
        "   | " + " " * 19 + "left",
    ]


def test_long_lines_cost_no_time() -> None:
    source = Source("robot.conf", "x" * 5_000_000)
    marks = [Mark(source.span(at, at + 1), "error") for at in range(0, 5_000_000, 500_000)]
    (frame,) = frames(marks)
    assert len(list(draw(frame, 1, 80, PLAIN))) == 1 + 2 * len(marks)
