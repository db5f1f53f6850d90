"""The udev rules parser: tokens with their places, and recovery line by line."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint.model.udev import RulesFile
from bringup_lint.parsers.udev import parse
from bringup_lint.parsers.udev_command import read_command
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span


def read(text: str, template: str = "") -> RulesFile:
    return parse(Source("99-robot.rules", text, template=template))


def span_of(where: Located | Span) -> Span:
    return where.span if isinstance(where, Located) else where


def test_tokens_know_their_places() -> None:
    (rule,) = read('SUBSYSTEM == "tty",ATTRS{idVendor}=="0403" SYMLINK+="robot/imu"\n').rules
    assert [token.name for token in rule.tokens] == ["SUBSYSTEM", "ATTRS{idVendor}", "SYMLINK"]
    assert [token.value.span.text for token in rule.tokens] == ["tty", "0403", "robot/imu"]
    assert rule.tokens[0].span.text == 'SUBSYSTEM == "tty"'
    assert rule.tokens[2].operator.span.column == 51


def test_a_comment_between_continued_lines_is_skipped() -> None:
    (rule,) = read('KERNEL=="a", \\\n  # why\n  SYMLINK+="b"\n').rules
    assert [(token.key, token.span.line) for token in rule.tokens] == [("KERNEL", 1), ("SYMLINK", 3)]


def test_carriage_returns_are_fine() -> None:
    file = read('KERNEL=="a", \\\r\n  SYMLINK+="b"\r\n')
    assert len(file.rules) == 1
    assert not file.problems


def test_escapes() -> None:
    (rule,) = read(r'KERNEL==e"a\x41\"b", SYMLINK+="c\"d\e"').rules
    assert [token.value for token in rule.tokens] == ['aA"b', 'c"d\\e']
    assert rule.tokens[0].value.part(1, 2).span.column == 12


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("SUBSYSTEM=='tty', SYMLINK+=\"a\"", "single-quoted-value"),
        ('SUBSYSTEM==tty, SYMLINK+="a"', "unquoted-value"),
        ('SUBSYSTEM=="tty, SYMLINK+=a', "value-not-closed"),
        ('SUBSYSTEM "tty", SYMLINK+="a"', "no-operator"),
        ('ATTRS{idVendor=="tty", SYMLINK+="a"', "attribute-not-closed"),
        ('KERNEL=="a", \\ \nSYMLINK+="b"', "blank-after-backslash"),
        ('KERNEL=="a", SYMLINK+="b" \\', "end-of-file-in-rule"),
        ('KERNEL==e"\\q", SYMLINK+="b"', "bad-escape"),
        ('SUBSYTEM=="tty", SYMLINK+="a"', "unknown-key"),
        ('BUS=="usb", SYMLINK+="a"', "removed-key"),
        ('\ufeffKERNEL=="a", SYMLINK+="b"', "byte-order-mark"),
        ('KERNEL{x}=="a", SYMLINK+="b"', "unexpected-attribute"),
        ('ATTR=="a", SYMLINK+="b"', "missing-attribute"),
        ('SUBSYSTEM="tty", SYMLINK+="a"', "match-only-key"),
        ('GROUP=="dialout"', "invalid-operator"),
        ('ENV{DEVNAME}="x"', "read-only-property"),
        ('IMPORT{builtin}="frobnicate"', "unknown-builtin"),
        ('KERNEL=="' + "a" * 17000 + '", SYMLINK+="b"', "line-too-long"),
    ],
)
def test_errors_that_drop_the_line(text: str, code: str) -> None:
    file = read(text if text.endswith("\\") else text + "\n")
    assert code in [problem.code for problem in file.problems]
    assert file.rules[0].dropped


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('MODE+="0666"', "coerced-operator"),
        ('SYMLINK+="a%q"', "bad-substitution"),
        ('OPTIONS+="last_rule", SYMLINK+="a"', "unknown-option"),
        ('KERNEL=="a"', "no-effect"),
        ('GOTO="end"', "goto-without-label"),
        ('LABEL="end"\nGOTO="end"', "goto-backward"),
        ('LABEL="end"', "label-unused"),
        ('RUN+=""', "empty-value"),
    ],
)
def test_complaints_that_leave_the_line(text: str, code: str) -> None:
    file = read(text + "\n")
    assert code in [problem.code for problem in file.problems]
    assert not file.rules[-1].dropped


def test_a_broken_line_costs_that_line() -> None:
    file = read('KERNEL==ttyUSB0, SYMLINK+="a"\nKERNEL=="ttyUSB*", SYMLINK+="b"\n')
    assert [rule.dropped for rule in file.rules] == [True, False]
    assert [token.key for token in file.rules[0].tokens] == ["SYMLINK"]


def test_problems_of_a_template_are_not_told() -> None:
    file = read('{% if x %}\nKERNEL=={{k}}, SYMLINK+="a"\n{% endif %}\nMODE="{{mode}}"\n', template="jinja")
    assert not file.problems
    assert len(file.rules) == 2


PIECES = st.sampled_from(
    [
        "SUBSYSTEM",
        "ATTRS{idVendor}",
        "ATTR{",
        "}",
        "==",
        "!=",
        "+=",
        "=",
        '"',
        'e"',
        'i"',
        "\\",
        "\\\n",
        "\n",
        "\r\n",
        "tty",
        "%k",
        "$attr{x}",
        "$",
        "{",
        ",",
        " ",
        "#",
        "GOTO",
        "LABEL",
        '"end"',
        "\t",
        "\0",
        "\ufeff",
        "\\x",
        "|",
        "'",
    ]
)


@given(st.lists(PIECES | st.text(max_size=4), max_size=40).map("".join), st.sampled_from(["", "jinja"]))
def test_every_text_can_be_read_and_every_span_lies_inside(text: str, template: str) -> None:
    file = read(text, template)
    spans = [rule.span for rule in file.rules]
    spans += [token.span for rule in file.rules for token in rule.tokens]
    spans += [token.value.span for rule in file.rules for token in rule.tokens]
    spans += [span_of(problem.where) for problem in file.problems]
    assert all(0 <= span.start <= span.end <= len(text) for span in spans)
    assert set(file.owners) == set(range(len(file.problems)))


@pytest.mark.parametrize(
    ("command", "shell"),
    [("/bin/sh -c 'a | b'", True), ("sh -c a", True), ("/usr/bin/env bash", True), ("/bin/echo shell", False)],
)
def test_commands_that_a_shell_reads(command: str, shell: bool) -> None:
    (rule,) = read(f'KERNEL=="a", RUN+="{command}"\n').rules
    assert read_command(rule.tokens[1]).runs_shell == shell
