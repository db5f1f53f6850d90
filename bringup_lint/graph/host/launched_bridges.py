"""Bridges to the ROS graph that launch files start and that everybody on the network may use."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.addresses import is_loopback
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ListValue
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import TypedValue
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.model.launch_values import Value
    from bringup_lint.source import Span

LIMITS = {
    "rosbridge_server": ("topics_glob", "services_glob", "authenticate"),
    "foxglove_bridge": ("capabilities", "client_topic_whitelist", "tls"),
}
"""Packages whose server gives the graph to every client on all addresses by default -> the parameters that limit it.
Source: rosbridge_websocket.py (address ""), foxglove_bridge's README (address 0.0.0.0, capabilities)."""
_EVERYTHING = ("clientPublish", ".*")
"""Capabilities and patterns that leave a bridge open to those who publish."""
_OPERATOR = regex(r"(?:^|[/_.-])(?:pc|operator|monitor(?:ing)?|ground|groundstation|basestation)(?=[/_.-])", re.I)
"""Launch files for the computer of those who look at the robot."""


def launched_bridges(files: Files, launch: Launch) -> Iterator[tuple[str, Span]]:
    """The packages of open bridges, each with the place that starts it."""
    for node in launch.nodes:
        package = str(literal_text(node.package))
        if package not in LIMITS or node.by_default is not True or not node.file.source.judged:
            continue
        if files.purpose(node.file.source) is Purpose.ROBOT and not launch.simulated(node.file):
            executable = str(literal_text(node.executable))
            if "rosapi" not in executable and _is_open(node, LIMITS[package]):
                yield package, _address(node) or node.span
    yield from _included(files, launch)


def _included(files: Files, launch: Launch) -> Iterator[tuple[str, Span]]:
    """The launch files of the bridges' own packages that a file of the robot includes, with their defaults."""
    for expansion in launch.expansions:
        source = expansion.entry.source
        if (
            files.purpose(source) is not Purpose.ROBOT
            or launch.simulated(expansion.entry)
            or _OPERATOR.search(source.name)
        ):
            continue
        for include in expansion.includes:
            found = place(include.file) if include.source is expansion.entry and include.target is None else None
            if found is None or found.package not in LIMITS or include.conditions or include.action.open:
                continue
            limits = ("address", *LIMITS[found.package])
            if include.source.source.judged and not any(map(include.arguments.get, limits)):
                yield found.package, include.action.span


def _is_open(node: Started, limits: tuple[str, ...]) -> bool:
    """Whether nothing limits a bridge; parameters that are not known may."""
    for value in node.parameters:
        if not isinstance(value, DictValue):
            return False
        for key, inner in value.items:
            name = text_of(key)
            if name is None or (name in limits and _switches_on(inner)):
                return False
            address = _known(inner) if name == "address" else ""
            if address is None or is_loopback(address):
                return False
    return not node.arguments


def _switches_on(value: Value) -> bool:
    """Whether a limit may limit something: ``authenticate: False``, an empty list of topics, a list that names every
    topic and capabilities with that to publish do not."""
    if isinstance(value, ListValue):
        return not value.open and not any(text_of(item) in _EVERYTHING for item in value.items)
    known = text_of(value)
    literal = value.value if isinstance(value, Literal) else known
    return str(literal).lower() not in ("false", "", "[]")


def _address(node: Started) -> Span | None:
    """Where a node itself is told to listen on all addresses."""
    for key, inner in node.given:
        if (
            text_of(key) == "address"
            and isinstance(inner, Literal)
            and node.span.start < inner.span.start < node.span.end
        ):
            return inner.span
    return None


def _known(value: Value | None) -> str | None:
    """The text of a value, that of an argument by its default."""
    if isinstance(value, TypedValue):
        return _known(value.value)
    if isinstance(value, Argument):
        return _known(value.default)
    return None if value is None else text_of(value)
