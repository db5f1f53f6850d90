"""Hardware of ros2_control that answers OK although it could not reach its device."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.hardware.hardware_interfaces import SIMULATED
from bringup_lint.graph.nodes.questions.hardware.hardware_interfaces import hardware
from bringup_lint.model.cpp_text import end_of_block
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_TELLS = regex(
    r"\b(?:ERROR|DEACTIVATE|throw)\b|(?i:fail|error|timeout|miss)\w{0,40}(?:\+\+|\s{0,4}\+=)"
    r"|\+\+\s{0,4}\w{0,40}(?i:fail|error|timeout|miss)"
)
"""What of a method answers otherwise, or counts failures."""
_OK = regex(r"\breturn\b[^;]{0,80}\bOK\s{0,4};")
_HANDLER = regex(r"\bcatch\s{0,4}\((?P<what>[^(){}]{0,200})\)\s{0,40}\{(?P<body>)")
_OF_VALUES = regex(r"\b(?:out_of_range|invalid_argument|bad_\w{1,40}|domain_error|length_error)\b")
"""Exceptions that a single value throws, not a device."""
_TEST = regex(
    r"\bif\s{0,4}\(\s{0,40}(?P<not>!\s{0,4})?(?P<call>[A-Za-z_][\w.:>-]{0,120})\s{0,4}\([^;{}]{0,300}\)"
    r"(?P<compared>\s{0,4}(?:!=\s{0,4}(?:0|true|\w{0,60}(?:SUCC|OK)\w{0,40})|<\s{0,4}0|==\s{0,4}(?:-1|false)))?\s{0,4}\)"
    r"\s{0,40}\{(?P<body>)"
)
_VERBS = "read|write|get|set|send|receive|recv|request|transfer|exchange|transmit|update|sync|communicate|poll|query"
_EXCHANGES = regex(
    rf"(?:\b|_)(?i:{_VERBS})(?![a-z])|(?<=[a-z])(?:{'|'.join(map(str.capitalize, _VERBS.split('|')))})(?![a-z])"
)
_LOG = regex(
    r"\b(?:RCLCPP_\w{3,40}|printf|fprintf|perror|(?:spdlog::)?(?:warn|error|info))\s{0,4}\((?:[^;\"]|\"(?:[^\"\\\n]|\\.)*\"){0,900}\)\s{0,4};"
    r"|\bstd::c(?:err|out)\b(?:[^;\"]|\"(?:[^\"\\\n]|\\.)*\"){0,900};"
)
_MOVES_ON = regex(r"\s*(?:(?:continue|break)\s*;\s*)?\Z")
_EXPORTED = regex(
    r"\bPLUGINLIB_EXPORT_CLASS\s{0,4}\(\s{0,40}(?:::)?(?P<name>\w{1,80}(?:::\w{1,80}){0,4})\s{0,4},\s{0,40}"
    r"(?:::)?hardware_interface::"
)
_PLUGIN = regex(r"<plugin>\s{0,40}([\w:/]{1,200})\s{0,40}</plugin>", hints="<plugin>")


class HiddenFailure(NamedTuple):
    source: Source
    place: Span
    """The handler, or the test that a call failed."""
    method: str
    """``read`` or ``write``."""
    answer: Span
    """The OK that it returns then."""


class HiddenFailures(NamedTuple):
    """Those of one source."""

    places: list[HiddenFailure]
    is_described: bool
    """False where the descriptions of the tree name other hardware of the tree, and not this."""


def hidden_failures(nodes: Nodes) -> Iterator[HiddenFailures]:
    """The failures that ``read()`` and ``write()`` only report or pass over."""
    known = list(hardware(nodes))
    exported = {source: set(_EXPORTED.findall(plain)) for source, plain, _ in known}
    described = _described(nodes, set().union(*exported.values()))
    for source, plain, bodies in known:
        if SIMULATED.search(plain):
            continue
        found = [each for name in ("read", "write") for each in _hidden(source, plain, name, bodies.get(name))]
        if found:
            is_described = not described or not exported[source] or not exported[source].isdisjoint(described)
            yield HiddenFailures(found, is_described)


def _described(nodes: Nodes, names: set[str]) -> set[str]:
    """Those classes that a robot description names as its hardware."""
    texts = [each.text for each in nodes.files.of_kind("urdf")] if names else []
    return names & {name.replace("/", "::") for text in texts for name in _PLUGIN.findall(text)}


def _hidden(source: Source, plain: str, method: str, body: tuple[int, int] | None) -> Iterator[HiddenFailure]:
    answers = list(_OK.finditer(plain, *body)) if body is not None else []
    if body is None or not answers or _TELLS.search(_LOG.sub(" ", plain[slice(*body)])):
        return
    answer = Span(source, *answers[-1].span())
    for handler in _HANDLER.finditer(plain, *body):
        if not _OF_VALUES.search(handler["what"]) and _only_reports(plain, handler.start("body")):
            yield HiddenFailure(source, Span(source, handler.start(), handler.start("body") - 1), method, answer)
    for test in _TEST.finditer(plain, *body):
        failed = test["not"] or test["compared"]
        if failed and _EXCHANGES.search(test["call"]) and _only_reports(plain, test.start("body")):
            yield HiddenFailure(source, Span(source, test.start(), test.start("body") - 1), method, answer)


def _only_reports(plain: str, start: int) -> bool:
    return _MOVES_ON.match(_LOG.sub(" ", plain[start : end_of_block(plain, start)])) is not None
