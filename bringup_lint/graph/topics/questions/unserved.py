"""Clients of services and actions that wait forever, because what they call has another name."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.topics.questions.coexistence import coexist
from bringup_lint.graph.topics.questions.misspelt import nearly_equal
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.graph.topics.resolved.names import tail
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span
from bringup_lint.spelling import numbered

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.node_source import Endpoint

_SERVER = {"client": "service", "action-client": "action-server"}


class Unserved(NamedTuple):
    use: Use
    """The client."""
    meant: Use
    """The server, under the other name."""


def unserved(topics: Topics) -> Iterator[Unserved]:
    """Clients whose name nothing of the tree offers, each once: the type is one of the tree's own, and all of its
    servers start together with the client, under one other name with the same or nearly the same last part."""
    servers = [each for each in topics.endpoints if each.role in _SERVER.values()]
    offered = {(each.role, each.topic) for running in topics.runs for each in running.calls}
    said: set[Span] = set()
    for running in topics.runs:
        for use in running.calls:
            server = _SERVER.get(use.role)
            if server is None or use.where in said or (server, use.topic) in offered or not _is_own(topics, use):
                continue
            meant = _meant(running, use, servers)
            if meant is not None and not _may_be_elsewhere(topics, use, meant):
                said.add(use.where)
                yield Unserved(use, meant)


def _may_be_elsewhere(topics: Topics, use: Use, meant: Use) -> bool:
    """Whether another computer, or a program whose source is not read, may offer the name: the two differ in a number
    alone, or another file than that of the client mentions a namespace that is not the server's."""
    if numbered(use.topic, meant.topic):
        return True
    foreign = set(use.topic.split("/")[:-1]) - set(meant.topic.split("/")) - set((use.node.fqn or "").split("/"))
    return any(
        name.search(source.text)
        for name in (re.compile(rf"\b{re.escape(each)}\b") for each in sorted(foreign))
        for source in topics.files.sources
        if source is not use.where.source
    )


def _is_own(topics: Topics, use: Use) -> bool:
    """Whether only the tree can offer what a client calls: with a type of its own, under a name that is known. The
    releases of ROS do not agree whether the name of an action is remapped."""
    own = (use.type or "").partition("/")[0] in topics.launch.workspace.packages
    return own and (use.role == "client" or use.remapping is None) and use.where.source.judged


def _meant(running: Running, use: Use, servers: list[Endpoint]) -> Use | None:
    found = [each for each in running.calls if each.role == _SERVER[use.role] and each.type == use.type]
    places = {each.where for each in found}
    if len({each.topic for each in found}) != 1 or not coexist(found[0].node, use.node):
        return None
    if any(each.role == _SERVER[use.role] and each.span not in places and _may_serve(each, use) for each in servers):
        return None
    is_near = tail(found[0].topic) == tail(use.topic) or nearly_equal(found[0].topic, use.topic)
    return found[0] if is_near else None


def _may_serve(server: Endpoint, use: Use) -> bool:
    """Whether a server that does not start here has the type of a client, or may have it and its name."""
    if server.type is not None:
        return server.type == use.type
    return server.name is None or tail(server.name) == tail(use.topic)
