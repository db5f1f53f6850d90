"""The topics of one launched node: what its source or the table says, put through namespace, parameters, remappings."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.dataclass import replace
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.graph.topics.resolved.names import expand
from bringup_lint.graph.topics.resolved.names import full_complaint
from bringup_lint.graph.topics.resolved.names import refusal
from bringup_lint.graph.topics.resolved.parameters import Given
from bringup_lint.graph.topics.resolved.parameters import GivenParameters
from bringup_lint.graph.topics.resolved.parameters import ParameterSources
from bringup_lint.graph.topics.resolved.parameters import given_parameters
from bringup_lint.graph.topics.resolved.parameters import names
from bringup_lint.graph.topics.resolved.process_arguments import RosArguments
from bringup_lint.graph.topics.resolved.process_arguments import ros_arguments
from bringup_lint.graph.topics.resolved.qos_overrides import overridden
from bringup_lint.graph.topics.resolved.remapping import Remapping
from bringup_lint.graph.topics.resolved.remapping import node_name
from bringup_lint.graph.topics.resolved.remapping import node_namespace
from bringup_lint.graph.topics.resolved.remapping import remap
from bringup_lint.graph.topics.resolved.remapping import remapping
from bringup_lint.graph.topics.resolved.velocity_types import velocity_type
from bringup_lint.graph.topics.sources.known import VELOCITY
from bringup_lint.graph.topics.sources.known import KnownNode
from bringup_lint.graph.topics.sources.known import KnownTopic
from bringup_lint.graph.topics.sources.known import known_node
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.topics.sources.code import Code
    from bringup_lint.model.node_source import Endpoint
    from bringup_lint.model.node_source import Qos
    from bringup_lint.parsers.rviz import Display

TOPICS = ("publisher", "subscription")


def resolved_node(
    started: Started, code: Code | None, displays: list[Display], sources: ParameterSources
) -> LaunchedNode:
    """``code``: what the sources of the tree say about what is started; ``displays``: what RViz is told to show;
    ``sources``: where parameters come from."""
    resolver = _Resolver(started, code, sources)
    node = resolver.node()
    for display in displays:
        resolver.add_display(node, display)
    return node


class _Resolver:
    def __init__(self, started: Started, code: Code | None, sources: ParameterSources) -> None:
        self.started = started
        self.code = code
        self.sources = sources
        self.arguments: RosArguments = ros_arguments(started)
        self.rules = list(_rules(started, self.arguments))
        self.known_rules = self.arguments.known and len(self.rules) == len(self.arguments.remappings) + len(
            started.remappings
        )
        self.known = self.from_table() if code is None else None
        own = code.name if code is not None else self.known.name if self.known is not None else None
        self.name = node_name(self.rules, literal_text(started.name) if started.name is not None else own)
        space = started.namespace
        if code is not None and code.namespace is not None and space in (None, "/"):
            space = None
        self.namespace = node_namespace(self.rules, space, own)
        fqn = f"{self.namespace.rstrip('/')}/{self.name}" if self.name and self.namespace else None
        self.given: GivenParameters = given_parameters(sources, started, fqn, self.arguments)

    def node(self) -> LaunchedNode:
        node = LaunchedNode(self.started, self.name, self.namespace, given=self.given)
        if self.code is not None:
            node.complete = self.code.complete
            node.node_class = self.code.node_class
            for endpoint in self.code.endpoints:
                if endpoint.role in TOPICS:
                    node.complete &= self.from_source(node, endpoint)
                else:
                    self.add_call(node, endpoint)
            drop_ambiguous(node)
            return node
        if self.known is None:
            return node
        node.complete = self.known.complete
        for topic in self.known.topics:
            node.complete &= self.add_known(node, topic)
        return node

    def from_table(self) -> KnownNode | None:
        return known_node(str(literal_text(self.started.package)), str(self.started.program))

    def from_source(self, node: LaunchedNode, endpoint: Endpoint) -> bool:
        """Whether the endpoint's full name is known."""
        written: Located | str | None = endpoint.name
        given = None
        if endpoint.parameter is not None:
            written, given = self.parameter(str(endpoint.parameter), endpoint.name)
        if written is None:
            return False
        use = self.use(node, endpoint.role, written, endpoint.type, endpoint.qos, endpoint.span)
        if use is None:
            if given is not None and refusal(written) is not None:
                node.refused.append(Given(written, given))
            return False
        use.given = given
        use.implied, use.conditional, use.lifecycle = endpoint.implied, endpoint.conditional, endpoint.lifecycle
        use.method = endpoint.method
        node.uses.append(overridden(use, self.given))
        return True

    def add_call(self, node: LaunchedNode, endpoint: Endpoint) -> None:
        """A service or action, where its full name is known."""
        is_given = endpoint.parameter is not None
        written = self.parameter(str(endpoint.parameter), endpoint.name)[0] if is_given else endpoint.name
        use = self.use(node, endpoint.role, written, endpoint.type, None, endpoint.span) if written else None
        if use is not None:
            node.calls.append(use)

    def parameter(self, name: str, default: Located | None) -> tuple[Located | str | None, Span | None]:
        if name in self.given.values:
            value, where = self.given.values[name]
            return (value, where) if isinstance(value, str) and value else (None, None)
        return (None, None) if self.given.open else (default, None)

    def add_known(self, node: LaunchedNode, topic: KnownTopic) -> bool:
        found = list(self.known_names(topic))
        type_, deciding = self.velocity_type() if topic.type == VELOCITY else (topic.type, None)
        for name, where in found:
            use = self.use(node, topic.role, name, type_, _qos(topic, self.started.span), self.started.span)
            if use is None:
                return False
            use.given, use.of_table, use.type_given = where, True, deciding
            node.uses.append(overridden(use, self.given))
        return bool(found) or not topic.parameter

    def velocity_type(self) -> tuple[str | None, Span | None]:
        package = str(literal_text(self.started.package))
        if package in self.sources.launch.workspace.packages:
            return None, None
        return velocity_type(package, self.sources.params().distribution, self.given)

    def add_display(self, node: LaunchedNode, display: Display) -> None:
        from bringup_lint.model.node_source import Qos

        span = display.policy.span
        qos = Qos(span, display.reliability, display.durability, "KEEP_LAST", display.depth)
        use = self.use(node, "subscription", display.topic, display.type, qos, span)
        if use is not None:
            use.shown = True
            node.uses.append(use)

    def known_names(self, topic: KnownTopic) -> Iterator[tuple[str, Span | None]]:
        if not topic.parameter:
            yield topic.name, None
        elif "*" in topic.parameter:
            for name in names(self.given, topic.parameter):
                given = self.given.values[name]
                if isinstance(given.value, str) and given.value:
                    yield given.value, given.where
        else:
            value, where = self.parameter(topic.parameter, None)
            if value is not None:
                yield value, where
            elif topic.name and not self.given.open and topic.parameter not in self.given.values:
                yield topic.name, None

    def use(
        self, node: LaunchedNode, role: str, written: str, type_: str | None, qos: Qos | None, where: Span
    ) -> Use | None:
        full = expand(written, self.name, self.namespace)
        if full is None or full_complaint(full) or not self.known_rules:
            return None
        name, by = remap(self.rules, full, self.name, self.namespace)
        if name is None or full_complaint(name):
            return None
        return Use(role, name, type_, qos, node, where, written, by)


def _all_made(uses: list[Use]) -> bool:
    """Whether a node surely makes all of these: one function does, under no condition."""
    return not any(use.conditional for use in uses) and len({use.method for use in uses}) == 1


def drop_ambiguous(node: LaunchedNode) -> None:
    """What a node makes in one way or another, as a parameter decides, is not known: types and profiles that differ."""
    groups: dict[tuple[str, str], list[Use]] = {}
    for use in node.uses:
        groups.setdefault((use.role, use.topic), []).append(use)
    for uses in groups.values():
        if node.node_class is not None and _all_made(uses):
            continue
        if len({use.type for use in uses}) > 1:
            for use in uses:
                use.type = None
        if len({use.qos and replace(use.qos, span=node.started.span) for use in uses}) > 1:
            for use in uses:
                use.qos = None


def _rules(started: Started, arguments: RosArguments) -> Iterator[Remapping]:
    """Those of the command line come before those of launch."""
    yield from arguments.remappings
    for source, target in started.remappings:
        before, after = text_of(source), text_of(target)
        if before is None:
            continue
        rule = remapping(f"{before}:={after if after is not None else 'unknown'}", target.span)
        if rule is not None:
            yield rule if after is not None else rule._replace(replacement=None)


def _qos(topic: KnownTopic, where: Span) -> Qos | None:
    from bringup_lint.model.node_source import INFINITE
    from bringup_lint.model.node_source import Qos

    if topic.reliability is None:
        return None
    policies = (topic.reliability, topic.durability, "KEEP_LAST", topic.depth)
    return Qos(where, *policies, deadline=INFINITE, liveliness="AUTOMATIC", lease=INFINITE)
