"""Remapping rules as rcl applies them: node, namespace and topics; the first rule that matches wins."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.resolved.names import expand
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span

_NAME = r"(?:~/|/)?(?!\d)\w+(?:/(?!\d)\w+)*"
_RULE = regex(
    rf"(?:(?P<node>(?!\d)\w+):(?!=|//))?"
    rf"(?:(?P<special>__node|__name|__ns):=(?P<name>/?{_NAME}|/)"
    rf"|(?P<kind>rostopic://|rosservice://)?(?P<match>{_NAME}):=(?P<to>{_NAME}))",
    re.A,
)
_PREFIX = regex(r"^(?:\w+:(?!//))?(?:rostopic://|rosservice://)?")
NODE = ("__node", "__name")
NAMESPACE = "__ns"


class Remapping(NamedTuple):
    """``match:=replacement``, for one node of the process when it names one."""

    match: str
    replacement: str | None
    """None when it is not known."""
    node: str | None
    kind: str
    """``topic``, ``service``, or ``any``."""
    where: Span | None


def remapping(text: str, where: Span | None = None) -> Remapping | None:
    """A rule as ``-r`` takes it; None when rcl does not read it."""
    found = _RULE.fullmatch(text)
    if found is None:
        return None
    if found["special"]:
        return Remapping(found["special"], found["name"], found["node"], "any", where)
    if not (is_remapped_name(found["match"]) and is_remapped_name(found["to"])):
        return None
    kind = {"rostopic://": "topic", "rosservice://": "service"}.get(found["kind"] or "", "any")
    return Remapping(found["match"], found["to"], found["node"], kind, where)


def is_remapped_name(text: str) -> bool:
    """Whether a side of a rule is a name as rcl's lexer takes it: no ``__``, no slash at its end, no substitution."""
    return bool(re.fullmatch(_NAME, text, re.A)) and "__" not in text


def node_name(rules: Iterable[Remapping], name: str | None) -> str | None:
    """What a node is called in the end; ``name`` is what its code calls it. None when that is not known."""
    return _renamed(rules, NODE, name, name)


def node_namespace(rules: Iterable[Remapping], namespace: str | None, name: str | None) -> str | None:
    return _renamed(rules, (NAMESPACE,), namespace, name)


def _renamed(rules: Iterable[Remapping], matches: tuple[str, ...], before: str | None, name: str | None) -> str | None:
    for rule in rules:
        if rule.match in matches and rule.node in (None, name):
            return rule.replacement
        if rule.match in matches and name is None:
            return None
    return before


class Remapped(NamedTuple):
    name: str | None
    """None when it is not known."""
    by: Remapping | None


def remap(rules: Iterable[Remapping], full: str, node: str | None, namespace: str | None) -> Remapped:
    """The name under which a topic of a node is really known; ``full`` is its expanded name."""
    for rule in rules:
        if rule.kind == "service" or rule.match in (*NODE, NAMESPACE):
            continue
        if rule.node is not None and rule.node != node:
            if node is None and expand(rule.match, None, namespace) in (None, full):
                return Remapped(None, rule)
            continue
        match = expand(rule.match, node, namespace)
        if match is None and (node is None or namespace is None):
            return Remapped(None, rule)
        if match == full:
            return Remapped(rule.replacement and expand(rule.replacement, node, namespace), rule)
    return Remapped(full, None)


def refused_sides(started: Started) -> Iterator[Located]:
    """The sides of a node's remappings for which rcl refuses the rule, so that the process ends. A default from
    elsewhere in the file may be what a node under a condition is not started with."""
    for pair in started.remappings:
        sides = [side for value in pair if (side := literal_text(value)) is not None]
        if len(sides) < 2 or remapping(f"{sides[0]}:={sides[1]}") is not None:
            continue
        for side in sides:
            own = started.by_default is True or started.span.holds(side.span)
            if own and not is_remapped_name(_PREFIX.sub("", side)):
                yield side
