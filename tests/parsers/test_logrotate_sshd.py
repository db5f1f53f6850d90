"""The parsers of logrotate's and sshd's configuration: no text makes them raise, and every place lies inside the
text."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies

from bringup_lint.parsers import logrotate
from bringup_lint.parsers import sshd
from bringup_lint.source import Located
from bringup_lint.source import Source

PIECES = (
    "\n",
    " ",
    "\t",
    "#",
    "{",
    "}",
    '"',
    "'",
    "\\",
    "=",
    "/var/log/a.log",
    "rotate 7",
    "size 10M",
    "postrotate",
    "endscript",
)
PIECES += (
    "su root root",
    "create 0640",
    "weekly",
    "Port 22",
    "Match User x",
    "Match all",
    "Include y",
    "Subsystem s t",
    "\r\n",
    "é",
)
TEXTS = strategies.lists(strategies.sampled_from(PIECES) | strategies.text(max_size=4), max_size=40).map("".join)


def inside(value: object, source: Source) -> bool:
    span = value.span if isinstance(value, Located) else value
    return 0 <= span.start <= span.end <= len(source.text)


@given(TEXTS)
def test_logrotate_reads_any_text(text: str) -> None:
    source = Source("robot", text)
    file = logrotate.parse(source)
    assert all(inside(problem.where, source) for problem in file.problems)
    for stanza in file.stanzas:
        assert all(inside(path, source) for path in stanza.paths)
        assert all(inside(each.span, source) and inside(each.value, source) for each in stanza.directives)
        assert all(inside(script.span, source) and inside(script.body, source) for script in stanza.scripts)


@given(TEXTS)
def test_sshd_reads_any_text(text: str) -> None:
    source = Source("sshd_config", text)
    file = sshd.parse(source)
    assert all(inside(problem.where, source) for problem in file.problems)
    assert all(inside(word, source) for option in file.options for word in (option.keyword, *option.arguments))


@pytest.mark.parametrize("parse", [logrotate.parse, sshd.parse])
def test_time_grows_with_the_text_only(parse) -> None:
    text = '/var/log/a.log {\n    rotate 7\n}\n"' * 3000 + "Port 22 \\" * 3000
    parse(Source("long", text))


@pytest.mark.parametrize("line", ['Include ""', 'Include "" /etc/ssh/robot.conf'])
def test_an_empty_name_is_no_file_to_include(line: str) -> None:
    (problem,) = sshd.parse(Source("sshd_config", line + "\n")).problems
    assert problem.detail == "a file name"


def test_scripts_of_a_stanza_that_is_left_out_are_skipped() -> None:
    text = "/a.log {\n  =bad\n  postrotate\n    echo endscript }\n  }\n  endscript\n}\n/b.log {\n  weekly\n}\n"
    file = logrotate.parse(Source("robot", text))
    assert [str(path) for stanza in file.stanzas for path in stanza.paths] == ["/a.log", "/b.log"]
    assert [problem.where for problem in file.problems] == ["=bad"]
