"""Names of topics, services, actions and nodes that one place of the policies has, a letter away from one of others."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.node_topics import published
from bringup_lint.graph.topics.questions.single_names import a_letter_apart
from bringup_lint.graph.topics.questions.single_names import written_names
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

_NAMES = regex(
    r"<(topic|service|action)>[ \t]*~?/?([A-Za-z]\w*(?:/\w+)*)[ \t]*</"
    r"|<profile\b[^<>]{0,200}?\b(node)=[\"']([A-Za-z]\w*)[\"']",
    hints="<topic> <service> <action> <profile",
)
_POLICY = regex(r"<profile\b|=[\"'](?:ALLOW|DENY)[\"']")
_HEAD = 50_000
_CODE = ("python-node", "cpp-node", "launch-python", "launch-xml", "launch-yaml")


class MisspeltRight(NamedTuple):
    name: Located
    what: str
    """``topic``, ``service``, ``action`` or ``node``."""
    meant: Located


def misspelt_rights(files: Files) -> Iterator[MisspeltRight]:
    """Each once; the other name is in several places of the policies, or in a source of the tree."""
    policies = list(_policies(files))
    found: dict[str, list[tuple[str, Located]]] = {}
    for source in policies:
        for match in _NAMES.finditer(source.said):
            group = 2 if match[2] else 4
            found.setdefault(match[group], []).append((match[group - 1], source.located(*match.span(group))))
    if not found:
        return
    code = written_names(files.of_kind(*_CODE))
    others = {name: [place for _, place in each] for name, each in found.items() if len(each) > 1}
    for name, places in code.items():
        others.setdefault(name, places)
    for name, near in a_letter_apart([name for name, each in found.items() if len(each) == 1], others):
        what, place = found[name][0]
        is_judged = place.span.source.judged and name not in published()
        if is_judged and not _is_elsewhere(files, policies, name, place):
            yield MisspeltRight(place, what, others[near][0])


def _policies(files: Files) -> Iterator[Source]:
    """The policies, and the profiles that they include."""
    own = files.of_kind("sros2-policy")
    yield from own
    if own:
        paths = {source.absolute for source in own}
        for path in files.tree.paths:
            if path.endswith(".xml") and len(_POLICY.findall(files.tree.head(path, _HEAD))) > 1:
                source = files.tree.at(path)
                if source is not None and source.absolute not in paths:
                    yield source


def _is_elsewhere(files: Files, policies: list[Source], name: str, place: Located) -> bool:
    """Whether anything else names it."""
    word = re.compile(rf"(?<!\w){re.escape(name)}(?!\w)")
    sources = {source.absolute: source for source in (*files.sources, *policies)}
    texts = (source.text for source in sources.values() if name in source.text)
    return sum(len(word.findall(text)) for text in texts) > 1
