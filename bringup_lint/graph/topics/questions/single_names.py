"""Names of topics, services and actions that one source alone has, a letter away from a name that others have."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.node_topics import published
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.topics.questions.apart import are_together
from bringup_lint.graph.topics.questions.apart import named_in_sources
from bringup_lint.graph.topics.questions.misspelt import nearly_equal
from bringup_lint.graph.topics.questions.unmatched import FIRMWARE
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.spelling import Neighbours

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.node_source import Endpoint

_QUOTED = regex(r"[\"'](?:~?/)?([a-z]\w*(?:/\w+)*)[\"']")
_LISTED = regex(r"^[ \t]*-[ \t]+/([a-z]\w*(?:/\w+)*)[ \t]*\r?$", re.M)
_SHORTEST = 7
_FEWEST = 2
"""Files that have a name of which no end is known."""
_MOST = 2_000
_OTHER_SIDE = {
    "publisher": "subscription",
    "subscription": "publisher",
    "service": "client",
    "client": "service",
    "action-server": "action-client",
    "action-client": "action-server",
}
_UNJUDGED = (Purpose.TEST, Purpose.CI, Purpose.ARCHIVE)


class SingleName(NamedTuple):
    name: Located
    role: str
    label: str
    meant: str
    place: Located
    """Where the other name is written."""


def single_names(topics: Topics) -> Iterator[SingleName]:
    """Each once. The other name is that of an end of the same type, or is in several other files."""
    ends: dict[str, list[tuple[Source, str, Endpoint]]] = {}
    for source, label, end in named_in_sources(topics):
        name = _plain(end.name or "")
        if end.name is not None and not end.implied and len(name) >= _SHORTEST:
            ends.setdefault(name, []).append((source, label, end))
    if not ends or len(ends) > _MOST:
        return
    written = written_names(topics.files.sources)
    said: set[str] = set()
    for name, near in a_letter_apart(ends, written):
        found = ends[name]
        if near in said:
            continue
        source, label, end = found[0]
        if len(found) > 1 or not source.judged or topics.nodes.purpose(source) in _UNJUDGED or name in published():
            continue
        if topics.launch.workspace.is_vendored(source) or FIRMWARE.search(f"/{name}"):
            continue
        place = _place(topics, source, end, ends.get(near, ()), written[near])
        if place is not None and end.name is not None and _is_single(topics, name):
            lead = end.name[: len(end.name) - len(name)]
            said.add(name)
            yield SingleName(end.name, end.role, label, f"{lead}{near}", place)


def _plain(name: str) -> str:
    return str(name).lstrip("~/")


def written_names(sources: Iterable[Source]) -> dict[str, list[Located]]:
    """The quoted names of all files, and those of lists of YAML."""
    found: dict[str, list[Located]] = {}
    for source in sources:
        text = source.said
        matches = list(_QUOTED.finditer(text))
        if " /" in text or "\t/" in text:
            matches = sorted((*matches, *_LISTED.finditer(text)), key=lambda match: match.start())
        for match in matches:
            if len(match[1]) >= _SHORTEST - 1:
                found.setdefault(match[1], []).append(source.located(*match.span(1)))
    return found


def a_letter_apart(ends: Iterable[str], written: Iterable[str]) -> Iterator[tuple[str, str]]:
    """Each name of an end with the only other one that is a letter away from it."""
    names = list(ends)
    known = Neighbours(_alike(names, written))
    for name in names:
        near = [other for other in known.near(name) if _is_slip(name, other)]
        if len(near) == 1:
            yield name, near[0]


def _alike(names: list[str], written: Iterable[str]) -> Iterator[str]:
    """Without those that have neither the first nor the last half of a name, and so are not a letter away from it."""
    half = max(min(map(len, names), default=0) - 1, 0) // 2
    starts, stops = {name[:half] for name in names}, {name[len(name) - half :] for name in names}
    return (each for each in written if each[:half] in starts or each[max(len(each) - half, 0) :] in stops)


def _is_slip(name: str, other: str) -> bool:
    """Whether one letter differs, inside a word of some length: numbers and plurals are other names."""
    if name.replace("_", "") == other.replace("_", "") or not nearly_equal(name, other):
        return False
    return not any(one == f"{two}s" for ours in [name.split("/")] for one, two in _words(ours, other.split("/")))


def _words(ours: list[str], theirs: list[str]) -> Iterator[tuple[str, str]]:
    for one, two in zip(ours, theirs, strict=True):
        for own, their in zip(one.split("_"), two.split("_"), strict=False):
            yield own, their
            yield their, own


def _place(
    topics: Topics,
    source: Source,
    end: Endpoint,
    others: Iterable[tuple[Source, str, Endpoint]],
    written: list[Located],
) -> Located | None:
    """Where the other name is: at the other side of the type, or at the same one if others have it as well."""
    elsewhere = [each for each in written if each.span.source is not source]
    together = [each for each in elsewhere if are_together(topics, source, each.span.source)]
    for its, _, each in others:
        if its is source or each.name is None or end.type is None or each.type != end.type:
            continue
        is_other_side = each.role == _OTHER_SIDE.get(end.role)
        if are_together(topics, source, its) and (is_other_side or len(written) >= _FEWEST):
            return each.name
    files = {each.span.source.name for each in together}
    return together[0] if len(files) >= _FEWEST else None


def _is_single(topics: Topics, name: str) -> bool:
    """Whether the name is in one place of the tree."""
    pattern = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
    texts = (source.text for source in topics.files.sources if name in source.text)
    return sum(len(pattern.findall(text)) for text in texts) == 1
