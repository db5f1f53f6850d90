"""Handlers of signals that wait for a lock, with the place that registers each."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.threads import package_sources
from bringup_lint.model.cpp_driver import WaitingHandler
from bringup_lint.model.cpp_text import plain_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_REGISTERS = regex(
    r"\b(?:signal\s{0,4}\(\s{0,4}SIG(?:INT|TERM|HUP|QUIT)\s{0,4},|sa_handler\s{0,4}=)\s{0,4}&?\s{0,4}"
    r"(?:\w+::)*(?P<name>\w+)",
    hints="signal sa_handler",
)


class RegisteredHandler(NamedTuple):
    handler: WaitingHandler
    registered: Located


def waiting_handlers(nodes: Nodes) -> Iterator[RegisteredHandler]:
    """Each once, where its package registers it for a signal that ends programs."""
    for driver in nodes.drivers:
        for handler in driver.waiting_handlers:
            registered = _registered(nodes, handler)
            if registered is not None:
                yield RegisteredHandler(handler, registered)


def _registered(nodes: Nodes, handler: WaitingHandler) -> Located | None:
    for each in package_sources(nodes, handler.place.span.source):
        found = _places(each).get(handler.name) if each is not None and each.matches(_REGISTERS) else None
        if found is not None:
            return found
    return None


def _places(source: Source) -> dict[str, Located]:
    """Name of a handler -> the first place of a source that registers it."""
    return source.once(_places, lambda: _found(source))


def _found(source: Source) -> dict[str, Located]:
    found: dict[str, Located] = {}
    for each in _REGISTERS.finditer(plain_of(source)):
        found.setdefault(each["name"], source.located(*each.span("name")))
    return found
