"""Parameters that launched nodes of public packages have under other names since a release."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.gone_parameters import Gone
from bringup_lint.facts.ros.gone_parameters import gone_parameter
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.questions.undeclared import GivenName
from bringup_lint.graph.topics.questions.undeclared import given_together
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.topics import Topics


class GoneParameters(NamedTuple):
    """Parameters of one block or launch action that have their names no longer since the same release."""

    node: LaunchedNode
    given: tuple[tuple[GivenName, Gone], ...]


def gone_parameters(topics: Topics) -> Iterator[GoneParameters]:
    """What is given together, each once; silent where another program gets the same."""
    named = topics.files.target.named
    facts: dict[Span, Gone | None] = {}
    groups: dict[tuple[Span, str], tuple[LaunchedNode, dict[Span, GivenName]]] = {}
    both: dict[Span, set[str]] = {}
    for node, given in given_together(topics):
        both.setdefault(given.group, set()).add(given.name)
        span = given.place.span
        gone = _gone(topics, node, given.name)
        facts[span] = gone if facts.get(span, gone) == gone else None
        if gone is not None and gone.is_for(named) and span.source.judged:
            groups.setdefault((given.group, gone.since), (node, {}))[1][span] = given
    for node, places in groups.values():
        known = ((given, facts[span]) for span, given in places.items())
        pairs = [(given, gone) for given, gone in known if gone is not None and gone.now not in both[given.group]]
        if pairs:
            yield GoneParameters(node, tuple(pairs))


def _gone(topics: Topics, node: LaunchedNode, name: str) -> Gone | None:
    package = literal_text(node.started.package)
    program = node.started.program
    if package is None or program is None or package in topics.launch.workspace.packages:
        return None
    return gone_parameter(package, program, name)
