"""Unit files: the line grammar, places, recovery."""

from __future__ import annotations

from hypothesis import given
from hypothesis import settings
from hypothesis import strategies as st

from bringup_lint.parsers.unit import parse
from bringup_lint.source import Source

LINES = st.sampled_from(
    [
        "[Unit]",
        "[Service]",
        "[",
        "[x",
        "Key=value",
        "Key=a \\",
        "  b \\",
        "# c",
        "; c",
        "",
        "  ",
        "\\",
        "=",
        "a",
        "K = v ",
        "\ufeff",
        "\0",
    ]
)
TEXT = st.one_of(
    st.text(max_size=200), st.lists(LINES, max_size=20).map("\n".join), st.lists(LINES, max_size=20).map("\r\n".join)
)


def unit(text: str, name: str = "robot.service"):
    return parse(Source(name, text, "systemd-unit"))


def pairs(text: str) -> list[tuple[str, str, str]]:
    return [(str(a.section), str(a.key), str(a.value)) for a in unit(text).assignments]


def codes(text: str) -> list[str]:
    return [problem.code for problem in unit(text).problems]


def test_blanks_around_equals_and_repeated_sections() -> None:
    text = "[Unit]\n A = b = c \n[Service]\nB=\n[Unit]\nC=d"
    assert pairs(text) == [("Unit", "A", "b = c"), ("Service", "B", ""), ("Unit", "C", "d")]


def test_comments_inside_a_continuation_are_skipped() -> None:
    assert pairs("[S]\nA=b \\\n# no\n  ; no\n   c\n") == [("S", "A", "b  c")]


def test_an_even_number_of_backslashes_does_not_continue() -> None:
    assert pairs("[S]\nA=b\\\\\nC=d\n") == [("S", "A", "b\\\\"), ("S", "C", "d")]


def test_blank_line_ends_a_continuation() -> None:
    assert pairs("[S]\nA=b \\\n\nC=d\n") == [("S", "A", "b"), ("S", "C", "d")]
    assert codes("[S]\nA=b \\\n\nC=d\n") == ["continuation-at-end"]


def test_trailing_backslash_at_the_end() -> None:
    assert codes("[S]\nA=b \\") == ["continuation-at-end"]


def test_backslash_and_blank() -> None:
    assert codes("[S]\nA=b \\ \nc\n") == ["backslash-blank", "missing-equals"]


def test_crlf_and_byte_order_mark() -> None:
    assert pairs("\ufeff[S]\r\nA=b\\\r\n c\r\n") == [("S", "A", "b c")]


def test_lines_before_the_first_section() -> None:
    assert codes("A=b\n[S]\nC=d\n") == ["line-outside-section"]


def test_words_know_their_lines() -> None:
    (assignment,) = unit("[S]\nA=one \\\n# no\n  two\n").assignments
    assert [(word, word.span.line, word.span.column) for word in assignment.value.words()] == [
        ("one", 2, 3),
        ("two", 4, 3),
    ]


def test_placeholders_make_a_value_opaque() -> None:
    file = parse(
        Source("robot.service.in", "[Service]\nUser=@USER@\nGroup=robot\n", "systemd-unit", template="configure")
    )
    assert file.name == "robot.service"
    assert [assignment.opaque for assignment in file.assignments] == [True, False]


@settings(deadline=None)
@given(TEXT)
def test_never_raises_and_every_span_lies_in_the_text(text: str) -> None:
    file = unit(text)
    spans = [assignment.span for assignment in file.assignments]
    spans += [value.span for a in file.assignments for value in (a.key, a.value, *a.value.words())]
    spans += [problem.where.span if hasattr(problem.where, "span") else problem.where for problem in file.problems]
    assert all(0 <= span.start <= span.end <= len(text) for span in spans)


@settings(deadline=None)
@given(TEXT)
def test_words_are_what_stands_there(text: str) -> None:
    for assignment in unit(text).assignments:
        for word in assignment.value.words():
            if "\\" not in word.span.text and "\n" not in word.span.text:
                assert word.span.text == word
