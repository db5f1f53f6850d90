"""supervisord.conf as Python's configparser reads it for supervisord."""

from __future__ import annotations

from configparser import Error
from configparser import RawConfigParser

from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.supervisord import Program
from bringup_lint.parsers.supervisord import parse
from bringup_lint.source import Source


def programs(text: str) -> list[Program]:
    return parse(Source("supervisord.conf", text, kind="supervisord"))


def test_comments_and_continuations_are_no_part_of_a_value() -> None:
    (program,) = programs(
        "[supervisord]\nuser=root\n[program:drive]\ncommand = ros2 run a b ; the driver\n"
        'environment=A="1",\n    B="2"\n; user=nobody\n[group:all]\nprograms=drive\n'
    )
    assert program.name == "drive"
    assert program.get("command") == "ros2 run a b"
    assert program.get("user") is None
    assert (program.get("environment") or "").split() == ['A="1",', 'B="2"']


LINES = st.sampled_from(
    ["[program:a]", "[program:b]", "[group:c]", "command=x y", "user : rover", "  more", "; note", "key=1 ; 2", ""]
)


@given(st.lists(LINES, max_size=12).map("\n".join))
def test_values_are_those_of_configparser(text: str) -> None:
    """The reference is the reader that supervisord itself uses, with its settings."""
    real = RawConfigParser(inline_comment_prefixes=(";", "#"), strict=False)
    try:
        real.read_string(text)
    except Error:
        return
    expected = {
        section: {key: " ".join(value.split()) for key, value in real.items(section)}
        for section in real.sections()
        if section.startswith("program:")
    }
    found: dict[str, dict[str, str]] = {}
    for program in programs(text):
        values = {key: " ".join(str(value).split()) for key, value in program.settings.items()}
        found.setdefault(f"program:{program.name}", {}).update(values)
    assert found == expected


@given(st.text(alphabet="[program:x]=;\n \t%ab\"'", max_size=200))
def test_nothing_raises_and_everything_lies_inside_the_text(text: str) -> None:
    for program in programs(text):
        for value in (program.name, *program.settings.values()):
            assert 0 <= value.span.start <= value.span.end <= len(text)
