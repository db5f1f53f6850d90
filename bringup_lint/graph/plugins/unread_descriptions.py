"""Robot descriptions that are not well-formed XML."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.plugins.named_descriptions import is_used
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.xml import parse

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.source import Problem
    from bringup_lint.source import Source

_READ = frozenset(
    {"doctype", "encoding", "entity", "too-deep", "too-large", "too-many-problems", "misplaced-declaration"}
)
"""What is no error, what a DOCTYPE may make right, and where our own reader stops. expat takes any version of XML."""
_REFUSED = frozenset(
    {"mismatched-tag", "stray-end-tag", "unclosed-element", "unclosed-markup", "duplicate-attribute", "bad-attribute"}
)
"""What TinyXML-2, with which urdfdom reads, refuses; so does expat, with which xacro may read the file. What ends in
`.xacro` surely is for expat, which takes only well-formed XML."""


class Unread(NamedTuple):
    problem: Problem
    by: str
    """The program that refuses the file."""
    used: bool
    """A launch file or another description names the file."""


def unread_descriptions(files: Files) -> Iterator[Unread]:
    """The first problem of each judged description that makes a program refuse it."""
    for source in files.of_kind("urdf"):
        problem = refused_xml(source) if source.judged and not source.template else None
        if problem is not None:
            yield Unread(problem, _reader(source), is_used(files, source))


def refused_xml(source: Source) -> Problem | None:
    """The first problem that makes a program refuse a description."""
    return next((each for each in parse(source).problems if _is_refused(each, _reader(source))), None)


def _reader(source: Source) -> str:
    return "xacro" if source.name.endswith(".xacro") else "urdfdom"


def _is_refused(problem: Problem, by: str) -> bool:
    if by == "urdfdom":
        return problem.code in _REFUSED
    is_version = problem.code == "bad-declaration" and "version=" in problem.span.text
    return problem.code not in _READ and not is_version
