"""The running graph compared with the files."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from collections.abc import Collection
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.launch.lifecycle import Managed
from bringup_lint.graph.launch.lifecycle import Manager
from bringup_lint.graph.launch.lifecycle import managers
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.observed.domains import Domain
from bringup_lint.graph.observed.domains import configured
from bringup_lint.graph.observed.domains import of_environment
from bringup_lint.graph.observed.expected import Entry
from bringup_lint.graph.observed.expected import Expected
from bringup_lint.graph.observed.expected import ExpectedNode
from bringup_lint.graph.observed.parameters import Given
from bringup_lint.graph.observed.parameters import given
from bringup_lint.graph.observed.tools import comes_with
from bringup_lint.graph.observed.tools import is_tool
from bringup_lint.graph.observed.topics import Meant
from bringup_lint.graph.observed.topics import Topic
from bringup_lint.graph.observed.topics import meant
from bringup_lint.graph.observed.topics import topics
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.model.observed import Endpoint
from bringup_lint.model.observed import ObservedGraph
from bringup_lint.model.observed import RunningNode
from bringup_lint.model.observed import RunningUnit
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.commands.environment import Variable
    from bringup_lint.graph.environment.ros import KnownSetting
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.topics.topics import Topics


@dataclass(eq=False)
class Observed:
    """What runs, what should, and where the files speak of it."""

    graph: ObservedGraph
    expected: Expected
    ros: RosEnvironment
    units: Callable[[], Units]
    launch: Launch
    node_topics: Topics
    """What the files say of the topics of nodes."""
    params: Callable[[], Params]
    complete: bool
    """Whether the files are a whole root file system."""

    @cached_property
    def nodes(self) -> list[RunningNode]:
        """The robot's own nodes: those of tools and of this program left out."""
        return [node for node in self.graph.nodes if self.is_own(node.name)]

    def is_own(self, name: str) -> bool:
        """Whether a node may be the robot's: a file names it, or it has not the name of a tool."""
        return not is_tool(name) or self.expected.named(name) is not None

    @cached_property
    def names(self) -> frozenset[str]:
        return frozenset(str(node.name) for node in self.graph.nodes)

    @cached_property
    def loaded_units(self) -> list[tuple[Unit, RunningUnit]]:
        """The system units of the tree, with what systemd says of them and of the instances of templates; none of
        which the tree has several."""
        units = [unit for unit in self.units().judged if unit.manager == "system"]
        counts = Counter(unit.name for unit in units)
        single = {unit.name: unit for unit in units if counts[unit.name] == 1}
        told = ((_file_name(str(running.name), counts), running) for running in self.graph.units)
        return [(single[name], running) for name, running in told if name in single]

    @cached_property
    def other_values(self) -> list[tuple[Given, Located]]:
        """The values of parameter files, with those that the nodes have instead; of a name that one node has."""
        if not self.graph.parameters:
            return []
        counts = Counter(str(node.name) for node in self.graph.nodes)
        told = {(str(each.node), str(each.name)): each.value for each in self.graph.parameters}
        pairs = ((each, told.get((each.node, each.name))) for each in given(self.params()))
        return [
            (each, value)
            for each, value in pairs
            if value is not None and counts[each.node] == 1 and not each.is_like(value)
        ]

    @cached_property
    def elsewhere(self) -> dict[int, list[RunningNode]]:
        """The robot's nodes on the other domains that were looked at."""
        return {domain: [node for node in nodes if self.is_own(node.name)] for domain, nodes in self.graph.elsewhere}

    @cached_property
    def configured(self) -> Domain | None:
        """The domain that the files agree on."""
        return configured(self.ros)

    @cached_property
    def astray(self) -> dict[tuple[Entry, int], list[RunningNode]]:
        """The nodes that must run on this domain and run on another one, by what starts them and where they are."""
        found = {}
        for entry, (domain, nodes) in product(self.due, self.elsewhere.items()):
            names = {node.name for node in self.expected.entries[entry]} - self.names
            there = [node for node in nodes if node.name in names]
            if there:
                found[entry, domain] = there
        return found

    def sets_domain(self, entry: Entry) -> bool:
        """Whether the nodes that something starts get the domain of the files."""
        domain = of_environment(entry.environment)
        return domain is not None and self.configured is not None and domain.number == self.configured.number

    @cached_property
    def missing(self) -> dict[Entry, list[ExpectedNode]]:
        """The nodes that must run on this domain, do not, and are not seen on another one either."""
        found = {}
        others = {str(node.name) for nodes in self.elsewhere.values() for node in nodes}
        for entry in self.due:
            nodes = {node.name: node for node in self.expected.entries[entry]}
            absent = [node for name, node in nodes.items() if name not in self.names | others]
            if absent:
                found[entry] = absent
        return found

    @cached_property
    def due(self) -> list[Entry]:
        """The entries that must have come up on this domain: all; but where several places of a repository start nodes,
        which may be robots or variants of their own, only those that come up together with one that did."""
        here = [entry for entry in self.expected.entries if self._is_here(entry)]
        up = [entry for entry in here if self._is_up(entry)]
        groups = {entry.group for entry in (here if self.complete or not up else up)}
        return [
            entry for entry in here if entry.group in groups and not any(self._conflict(entry, each) for each in up)
        ]

    def _is_here(self, entry: Entry) -> bool:
        domain = of_environment(entry.environment)
        return domain is None or domain.number == self.graph.domain

    def _is_up(self, entry: Entry) -> bool:
        """Whether a node runs that no other place of the tree starts."""
        others = [node for each, nodes in self.expected.entries.items() if each.group != entry.group for node in nodes]
        own = {node.name for node in self.expected.entries[entry]}
        return bool((own - {node.name for node in others} or own) & self.names)

    def _conflict(self, entry: Entry, other: Entry) -> bool:
        return bool(entry.unit and other.unit and self.units().conflict(entry.unit, other.unit))

    @property
    def wants(self) -> bool:
        """Whether something was not seen that should be there, and that may only be late."""
        silent = any(node.state == "no answer" for node in self.nodes)
        return bool(silent or self.missing or self.meant or not self.nodes)

    @cached_property
    def duplicates(self) -> list[list[RunningNode]]:
        """Nodes that share a name, together."""
        counts = Counter(str(node.name) for node in self.nodes)
        return [[node for node in self.nodes if node.name == name] for name, count in counts.items() if count > 1]

    def accounts_for(self, node: RunningNode) -> bool:
        """Whether the files name a running node, or one that brings it along."""
        known = self.expected.nodes
        return any(node.name == each.name or comes_with(node.name, each.name, each.package) for each in known)

    def namesake(self, name: str) -> RunningNode | None:
        """The only running node of the same bare name, when it has another namespace."""
        bare = name.rpartition("/")[2]
        found = [node for node in self.nodes if node.bare == bare and self.expected.named(node.name) is None]
        return found[0] if len(found) == 1 else None

    @cached_property
    def topics(self) -> list[Topic]:
        return topics(each for each in self.graph.endpoints if self.is_own(each.node))

    @cached_property
    def meant(self) -> list[Meant]:
        return list(meant(self.topics))

    @property
    def velocities(self) -> list[Topic]:
        """The topics with velocity commands, with what tools publish on them."""
        return [topic for topic in topics(self.graph.endpoints) if topic.is_velocity]

    @cached_property
    def security(self) -> Located | None:
        """What switches security on for a process of the robot; where the files start none, for any."""
        found: list[Variable | KnownSetting | None] = []
        if self.ros.processes:
            found += (each.environment.get("ROS_SECURITY_ENABLE") for each in self.ros.processes)
        else:
            found += (each for each in self.ros.of("ROS_SECURITY_ENABLE") if not self.ros.is_development(each.value))
        return next((each.value for each in found if each is not None and each.text == "true"), None)

    def place(self, name: str) -> Span:
        """Where the files start a node; where they do not, its line in the graph, else the graph."""
        known = self.expected.named(name)
        if known is not None:
            return known.where
        return next((node.name.span for node in self.graph.nodes if node.name == name), self.graph.source.whole)

    def named_at(self, endpoint: Endpoint) -> Span:
        """Where the files name an endpoint's topic: in the source, or in a remapping; else where its node is started;
        else its line in the graph."""
        use = self._use(endpoint)
        if use is not None:
            return use.name_place or use.where
        known = self.expected.named(endpoint.node)
        if known and known.started:
            for _, target in known.started.remappings:
                text, where = text_of(target), literal_text(target)
                if where is not None and text in (
                    endpoint.topic,
                    endpoint.topic.rpartition("/")[2],
                    endpoint.topic[1:],
                ):
                    return where.span
        return known.where if known else endpoint.topic.span

    def profile_at(self, endpoint: Endpoint) -> Span:
        """Where the files give an endpoint its quality of service; else as ``named_at``."""
        use = self._use(endpoint)
        return use.qos_place if use is not None else self.named_at(endpoint)

    def _use(self, endpoint: Endpoint) -> Use | None:
        """The endpoint in the source of its node."""
        known = self.expected.named(endpoint.node)
        role = "publisher" if endpoint.publishes else "subscription"
        if known and known.started:
            for use in self.node_topics.node(known.started).uses:
                if use.role == role and use.topic == endpoint.topic and not use.of_table:
                    return use
        return None

    @cached_property
    def managed(self) -> dict[str, tuple[Managed, Manager]]:
        """Full name -> the entry in the list of a lifecycle manager."""
        found: dict[str, tuple[Managed, Manager]] = {}
        for expansion in self.launch.entries:
            for manager in managers(expansion):
                for node in manager.managed or ():
                    found.setdefault(node.fqn, (node, manager))
        return found

    def stays_inactive(self, name: str) -> bool:
        """Whether the files leave it to somebody else to activate a node."""
        manager = self.managed[name][1] if name in self.managed else None
        if manager is None or not manager.autostart.known:
            return False
        value = manager.autostart.value
        return value is None or truth(value) is False


def _file_name(name: str, files: Collection[str]) -> str:
    """The unit file that a running unit has: its own, else that of its template."""
    prefix, at, rest = name.partition("@")
    return name if name in files or not at else f"{prefix}@.{rest.rpartition('.')[2]}"
