"""Velocities of Navigation2 that reach the base beside its collision monitor."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.params.loads import path_of
from bringup_lint.graph.topics.questions.coexistence import coexist
from bringup_lint.graph.topics.resolved.names import expand
from bringup_lint.graph.topics.resolved.remapping import remap
from bringup_lint.graph.topics.resolved.remapping import remapping
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
    from bringup_lint.graph.topics.resolved.endpoint_use import Running
    from bringup_lint.graph.topics.resolved.endpoint_use import Use
    from bringup_lint.graph.topics.topics import Topics

_MONITOR = "nav2_collision_monitor"
_PROGRAMS = ("collision_monitor", "nav2_collision_monitor::CollisionMonitor")
_OUT = "cmd_vel_out_topic"
_SERVERS = ("nav2_controller", "nav2_behaviors", "nav2_velocity_smoother")
"""What sends velocities that the monitor is there to look at."""


class Unmonitored(NamedTuple):
    monitor: LaunchedNode
    topic: str
    where: Span
    """The value that names what the monitor sends."""
    past: list[Use]
    """Servers that send on the same topic."""


def unmonitored(topics: Topics, running: Running) -> Iterator[Unmonitored]:
    for node in running.nodes:
        started = node.started
        if literal_text(started.package) != _MONITOR or started.program not in _PROGRAMS:
            continue
        given = _given(topics, node)
        name = _full(node, given[0]) if given is not None else None
        if given is None or name is None:
            continue
        past = [use for use in running.uses if use.topic == name and _is_of_server(use) and coexist(use.node, node)]
        if past:
            yield Unmonitored(node, name, given[1], past)


def _is_of_server(use: Use) -> bool:
    return use.role == "publisher" and literal_text(use.node.started.package) in _SERVERS


def _full(node: LaunchedNode, name: str) -> str | None:
    """The name that the topic has in the end."""
    rules = []
    for source, target in node.started.remappings:
        rule = remapping(f"{text_of(source)}:={text_of(target)}")
        if text_of(source) is None or text_of(target) is None or rule is None:
            return None
        rules.append(rule)
    full = expand(name, node.name, node.namespace)
    return remap(rules, full, node.name, node.namespace).name if full is not None else None


def _given(topics: Topics, node: LaunchedNode) -> tuple[str, Span] | None:
    """What the last of its parameters says that names the topic; None when that is not known."""
    for source in reversed(node.started.parameters):
        if isinstance(source, DictValue):
            value = source.get(_OUT)
            if value is not None:
                text = literal_text(value)
                return (str(text), text.span) if text is not None else None
            if source.open:
                return None
            continue
        base = _base(source)
        path = path_of(topics.launch, base) if base is not None else None
        file = topics.params().at_path(path) if path is not None else None
        if file is None or not file.accepted or file.uncertain or file.source.template:
            return None
        for block in reversed(file.blocks):
            if block.name.rpartition("/")[2] != node.name:
                continue
            for each in block.parameters:
                if each.name == _OUT:
                    data = each.value.data
                    return (data, each.span) if isinstance(data, str) and not {"$", "<"} & set(data) else None
    return None


def _base(source: Value) -> Value | None:
    """The file that others are made from; None when the topic may be written anew."""
    while isinstance(source, (ParameterFile, DerivedFile)):
        if isinstance(source, DerivedFile):
            rewrites = source.rewrites
            known = isinstance(rewrites, DictValue) and not rewrites.open and rewrites.get(_OUT) is None
            if rewrites is not None and not known:
                return None
        source = source.base if isinstance(source, DerivedFile) else source.file
    return None if isinstance(source, Choice) else source
