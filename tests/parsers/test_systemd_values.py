"""The value grammars of unit files: examples, and what must hold for any text."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bringup_lint import facts
from bringup_lint.facts.systemd import directives
from bringup_lint.parsers import systemd_values as values
from bringup_lint.parsers.systemd_values import nowhere
from bringup_lint.parsers.systemd_values.grammars import grammar

KINDS = sorted({found.type for section in directives.sections() for found in directives.of_section(section)})
TEXT = st.text(alphabet="abzAS019 \t\\\"'%;:@-+!./~,=$#{}&|()é\x07", max_size=40)


def test_every_type_of_the_table_has_a_grammar():
    for kind in KINDS:
        assert callable(grammar(kind))


def test_legacy_names_are_directives():
    for row in facts.table("systemd/legacy"):
        assert directives.directive(row["section"], row["key"])


@pytest.mark.parametrize("kind", KINDS)
@given(text=TEXT)
def test_no_text_makes_a_grammar_raise(kind, text):
    value = nowhere(text)
    for problem in values.check(kind, value, 249):
        assert 0 <= problem.where.span.start <= problem.where.span.end <= len(text)
        assert problem.effect in ("line", "word", "unit", "nothing")


@given(text=TEXT)
def test_words_of_a_command_line_know_their_place(text):
    for command in values.split_command_line(nowhere(text)).commands:
        for word in command.argv:
            assert 0 <= word.span.start <= word.span.end <= len(text)
            for index, char in enumerate(word):
                assert text[word.origin(index)] == char or "\\" in text


@pytest.mark.parametrize(
    ("text", "seconds"),
    [
        ("5", 5.0),
        ("5min 20s", 320.0),
        ("1.5", 1.5),
        ("5m 30", 330.0),
        ("1M", 2629800.0),
        ("infinity", math.inf),
        ("30sek", None),
        ("5ss", None),
        ("-5", None),
        ("", None),
        ("5.", None),
    ],
)
def test_time_spans(text, seconds):
    assert values.parse_timespan(text) == seconds


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("2G", 2**31),
        ("2 G", 2**31),
        ("1.5K", 1536),
        ("64", 64),
        ("2GB", None),
        ("64MB", None),
        ("-1", None),
        ("2g", None),
    ],
)
def test_sizes(text, size):
    assert values.parse_size(text) == size


def test_the_path_of_a_device_unit():
    assert values.escape_path("/dev/robot/front-lidar") == "dev-robot-front\\x2dlidar"
    assert values.unescape_path("dev-robot-front\\x2dlidar") == "/dev/robot/front-lidar"
    assert values.escape_path("/") == "-"


@pytest.mark.parametrize(
    ("name", "valid"),
    [
        ("a.service", True),
        ("a@.service", True),
        ("a@b@c.service", True),
        ("a", False),
        ("a.servce", False),
        ("@a.service", False),
    ],
)
def test_unit_names(name, valid):
    assert values.is_unit_name(name) is valid


def test_a_command_line_with_everything():
    line = values.split_command_line(nowhere('-@/bin/bash shell -c \'a && "b c"\' ; +/bin/echo \\; "x\\ty"'))
    first, second = line.commands
    assert (first.prefixes, first.program, first.argv0) == ("-@", "/bin/bash", "shell")
    assert first.arguments == ("-c", 'a && "b c"')
    assert first.where == "-@/bin/bash shell -c 'a && \"b c\"'"
    assert second.privileged
    assert second.arguments == (";", "x\ty")
    assert not line.problems


def test_an_unclosed_quote_spoils_the_line():
    (problem,) = values.split_command_line(nowhere("/bin/echo it's")).problems
    assert (problem.code, problem.where, problem.effect) == ("unbalanced-quotes", "'s", "unit")


def test_environment_words():
    found = values.split_environment(nowhere("A=1 \"B=two words\" 3C=no D= 'E=x=y'"))
    assert found == (("A", "1"), ("B", "two words"), ("D", ""), ("E", "x=y"))
    assert found[1].value.span.text == "two words"


def test_specifiers_that_follow_from_the_name():
    known = values.unit_specifiers("robot-drive@front-left.service")
    assert values.expand("%p|%i|%I|%n|%N|%j|100%%", known) == (
        "robot-drive|front-left|front/left|robot-drive@front-left.service|robot-drive@front-left|drive|100%"
    )
    assert values.expand("%H", known) is None


@pytest.mark.parametrize(
    ("kind", "text", "suggestion"),
    [
        ("memory-limit", "2GB", "2G"),
        ("memory-limit", "512MiB", "512M"),
        ("signal", "sigint", "SIGINT"),
        ("cpu-quota", "300", "300%"),
        ("units", "a.target,", "a.target"),
        ("command", "/bin/date +%F", "%%F"),
        ("enum:restart", "On-Failure", "on-failure"),
    ],
)
def test_suggestions(kind, text, suggestion):
    (problem,) = values.check(kind, nowhere(text), 249)
    assert problem.suggestion == suggestion


def test_unknown_capabilities_are_dropped_silently_and_still_reported():
    assert not list(values.check("capabilities", nowhere("~CAP_SYS_ADMIN cap_net_raw 12"), 249))
    (problem,) = values.check("capabilities", nowhere("CAP_NET_RAW CAP_SYS_NICEE"), 249)
    assert (problem.where, problem.suggestion) == ("CAP_SYS_NICEE", "CAP_SYS_NICE")


@pytest.mark.parametrize(
    ("kind", "lowest", "highest"), [("cpu-shares", 2, 262144), ("blockio-weight", 10, 1000), ("weight", 1, 10000)]
)
def test_bounds_of_numbers(kind, lowest, highest):
    fine = [number for number in (lowest - 1, lowest, highest, highest + 1) if accepts(kind, number)]
    assert fine == [lowest, highest]


def accepts(kind, number):
    return not list(values.check(kind, nowhere(str(number)), 249))
