"""The list in CYCLONEDDS_URI, variables in values, and inline XML with its places."""

from __future__ import annotations

import pytest

from bringup_lint.parsers.cyclonedds import parse
from bringup_lint.parsers.cyclonedds_uri import split_uri
from bringup_lint.parsers.environment import ExpansionError
from bringup_lint.parsers.environment import UnknownVariable
from bringup_lint.parsers.environment import expand
from bringup_lint.source import Source


def parts(text):
    source = Source("robot.env", text)
    return [(str(part.text), part.inline, part.text.span.start) for part in split_uri(source.located(0, len(text)))]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("", []),
        (" , ", []),
        ("/etc/a.xml", [("/etc/a.xml", False, 0)]),
        ("file:///etc/a.xml", [("/etc/a.xml", False, 7)]),
        ("a.xml, b.xml", [("a.xml", False, 0), ("b.xml", False, 7)]),
        ("<General/>", [("<General/>", True, 0)]),
        ("<General/>,a.xml", [("<General/>", True, 0), ("a.xml", False, 11)]),
        (
            "a.xml,<a><b x=','/></a> <c/>",
            [("a.xml", False, 0), ("<a><b x=','/></a>", True, 6), ("<c/>", True, 24)],
        ),
        ("<a><b>,file.xml", [("<a><b>,file.xml", True, 0)]),
    ],
)
def test_split(text, expected):
    assert parts(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("eth0", "eth0"),
        ("${A}", "x"),
        ("$A", "$A"),
        ("${B}", ""),
        ("${B:-y}", "y"),
        ("${B:-${A}}", "x"),
        ("${A:+z}", "z"),
        ("${B:+z}", ""),
        ("a${A}b", "axb"),
    ],
)
def test_expand(text, expected):
    assert expand(text, {"A": "x"}) == expected


def test_expand_refuses():
    for text in ("${A", "${A:=b}", "${B:?missing}"):
        with pytest.raises(ExpansionError):
            expand(text, {"A": "x"})
    with pytest.raises(UnknownVariable):
        expand("${A:-x}", None)


def test_inline_xml_keeps_its_place():
    text = "RMW=x\nCYCLONEDDS_URI=<General><Allow>no</Allow></General>\n"
    source = Source("robot.env", text)
    start = text.index("<")
    configuration = parse(source, inline=True, region=(start, len(text) - 1))
    found = {remark.code: remark.where for remark in configuration.all_remarks}
    assert found["value"].span.text == "no"
    assert found["abbreviated"].line == 2
