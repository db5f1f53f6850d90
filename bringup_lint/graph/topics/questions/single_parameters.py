"""Names of parameters that one place of the tree has, a letter away from a name that others have."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.parameters import is_of_library
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.topics.questions.apart import are_together
from bringup_lint.graph.topics.questions.single_names import a_letter_apart
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics

_DECLARED = regex(
    r"(?:declare_parameter\w*|[gs]et_parameter\w*|has_parameter)\s{0,20}(?:<[\w:<>, ]{1,60}>)?\(\s{0,80}"
    r"(?:\w+,\s{0,20}|\w+ ?\+ ?\"\.\" ?\+ ?){0,3}[\"']([A-Za-z][\w.]{5,80})[\"']",
    hints="parameter",
)
_LISTED = regex(r"\(\s{0,40}[\"']([A-Za-z][\w.]{5,80})[\"'],(?![^\n]*\bremap)", hints="(")
"""A parameter in the list that ``declare_parameters`` takes."""
_LIST = regex(r"declare_parameters\(", hints="declare_parameters")
_KEY = regex(r"^[ \t]+([A-Za-z][\w.]{5,80}):(?=[ \t\r\n])", re.M)
_DICT = regex(r"[\"']([A-Za-z][\w.]{5,80})[\"'][ \t]{0,4}:", hints=": :")
_PARAM = regex(r"<param\b[^<>]{0,200}?\bname=[\"']([A-Za-z][\w.]{5,80})[\"']", hints="<param")
_CODE = ("python-node", "cpp-node")
_GIVING = {"params": _KEY, "launch-python": _DICT, "launch-xml": _PARAM}
_UNJUDGED = (Purpose.TEST, Purpose.CI, Purpose.ARCHIVE)


class SingleParameter(NamedTuple):
    name: Located
    given: bool
    """A launch or parameter file gives it; else a source of a node asks for it or declares it."""
    meant: Located


def single_parameters(topics: Topics) -> Iterator[SingleParameter]:
    """Given names of which sources have the other one, and declared ones of which others have the other one."""
    declared = _found(topics, _CODE)
    if not declared:
        return
    given = _found(topics, tuple(_GIVING))
    both = {name: [*declared.get(name, ()), *given.get(name, ())] for name in {*declared, *given}}
    said: set[str] = set()
    for names, others, is_given in ((given, declared, True), (declared, both, False)):
        once = [name for name, places in names.items() if len(both[name]) == 1 and not is_of_library(name)]
        for name, near in a_letter_apart(once, others):
            place = names[name][0]
            meant = _meant(topics, place, others[near])
            if meant is not None and near not in said and _is_judged(topics, place) and _is_single(topics, name):
                said.add(name)
                yield SingleParameter(place, is_given, meant)


def _found(topics: Topics, kinds: tuple[str, ...]) -> dict[str, list[Located]]:
    found: dict[str, list[Located]] = {}
    for source in topics.files.of_kind(*kinds):
        patterns = [_GIVING.get(source.kind, _DECLARED)]
        if source.kind == "python-node" and source.says(_LIST):
            patterns.append(_LISTED)
        spans = {match.span(1) for pattern in patterns for match in pattern.finditer(source.said)}
        for start, end in sorted(spans):
            found.setdefault(source.text[start:end], []).append(source.located(start, end))
    return found


def _meant(topics: Topics, place: Located, others: list[Located]) -> Located | None:
    """Where another file of the same robot has the other name, or the same file several times."""
    source = place.span.source
    apart = [each for each in others if each.span.source is not source]
    together = [each for each in apart if are_together(topics, source, each.span.source)]
    return next(iter(together), None) or (others[0] if len(others) > 1 and len(apart) < len(others) else None)


def _is_judged(topics: Topics, place: Located) -> bool:
    source: Source = place.span.source
    is_own = source.judged and not topics.launch.workspace.is_vendored(source)
    return is_own and topics.files.purpose(source) not in _UNJUDGED


def _is_single(topics: Topics, name: str) -> bool:
    word = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
    texts = (source.text for source in topics.files.sources if name in source.text)
    return sum(len(word.findall(text)) for text in texts) == 1
