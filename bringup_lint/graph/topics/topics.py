"""The topic layer: what every launched node publishes and subscribes, and which nodes run together."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.topics.questions.coexistence import together
from bringup_lint.graph.topics.questions.compatibility import Conflict
from bringup_lint.graph.topics.questions.compatibility import conflicts
from bringup_lint.graph.topics.resolved import names
from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
from bringup_lint.graph.topics.resolved.endpoint_use import Pair
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.graph.topics.resolved.nodes import launched
from bringup_lint.graph.topics.resolved.remapping import refused_sides
from bringup_lint.graph.topics.resolved.systems import systems
from bringup_lint.graph.topics.sources.code import Code
from bringup_lint.graph.topics.sources.code import code_of
from bringup_lint.graph.topics.sources.cpp_code import CppCode
from bringup_lint.graph.topics.sources.rviz import Displays

if TYPE_CHECKING:
    from bringup_lint.graph.topics.questions.watch_lists import Missing
    from bringup_lint.graph.topics.resolved.node_names import NodeNames
    from bringup_lint.model.node_source import Endpoint
    from bringup_lint.robot import Robot
    from bringup_lint.source import Source
    from bringup_lint.source import Span

COMPARED = 100
"""Publishers and subscriptions of one topic that are held against each other."""
CPP = (".cpp", ".cc", ".cxx", ".hpp", ".h")


class Topics:
    def __init__(self, robot: Robot) -> None:
        self.robot = robot
        self._cpp = CppCode(robot)
        self._displays = Displays(robot)
        self._codes: dict[tuple[str | None, ...], Code | None] = {}
        self._launched: dict[int, LaunchedNode] = {}

    @cached_property
    def entries(self) -> list[Running]:
        """What each launch file starts that no other one includes."""
        return [self._running(each.entry.source.name, [each]) for each in self.robot.launch.entries]

    def code(self, started: Started) -> Code | None:
        """What the tree's sources say about a launched program."""
        program = tuple(literal_text(each) for each in (started.package, started.executable, started.plugin))
        if program not in self._codes:
            self._codes[program] = code_of(self.robot, started, self._cpp)
        return self._codes[program]

    def node(self, started: Started) -> LaunchedNode:
        if id(started) not in self._launched:
            self._launched[id(started)] = launched(self.robot, started, self.code(started), self._displays.of(started))
        return self._launched[id(started)]

    @cached_property
    def runs(self) -> list[Running]:
        """What runs together: each entry alone, and all that the units of one boot or one compose file launch."""
        found = [self._running(label, expansions, whole=whole) for label, expansions, whole in systems(self.robot)]
        return [*found, *self.entries]

    def _running(self, label: str, expansions: list[Expansion], *, whole: bool = False) -> Running:
        running = Running(label)
        started = [each for expansion in expansions for each in expansion.nodes]
        running.nodes = [self.node(each) for each in started if each.is_node]
        known = all(each.is_node for each in started) and not any(expansion.open for expansion in expansions)
        running.complete = known and all(node.complete for node in running.nodes)
        running.whole = running.complete and whole
        running.simulated = any(self.robot.launch.simulated(expansion.entry) for expansion in expansions)
        return running

    @staticmethod
    def types_differ(publisher: Use, subscription: Use) -> bool:
        return None not in (publisher.type, subscription.type) and publisher.type != subscription.type

    @staticmethod
    def does(use: Use) -> str:
        return "publishes" if use.role == "publisher" else "subscribes to"

    @staticmethod
    def conflicts(publisher: Use, subscription: Use) -> Iterator[Conflict]:
        """Where the publisher offers less than the subscription asks for, as far as both are known."""
        if publisher.qos is not None and subscription.qos is not None:
            yield from conflicts(publisher.qos, subscription.qos)

    @property
    def refused(self) -> Iterator[tuple[LaunchedNode, Span, str, str]]:
        """Names in parameters and remappings of launched nodes that rcl does not take: the node, the place, the name,
        and when it ends."""
        for running in self.entries:
            for node in running.nodes:
                for value, where in node.refused:
                    yield node, where, str(value), "when it creates the topic"
                for side in refused_sides(node.started):
                    yield node, side.span, str(side), "at start with 'Couldn't parse remap rule'"

    @property
    def endpoints(self) -> Iterator[Endpoint]:
        """Every endpoint in the sources of nodes, of tests none: all of Python, of C++ what launch files start."""
        for node in self.robot.nodes.classes:
            if self.robot.nodes.purpose(node.source) != "test":
                yield from node.endpoints
        seen = set()
        for running in self.entries:
            for node in running.nodes:
                code = self.code(node.started)
                if code is not None and code.node_class is None and id(code) not in seen:
                    seen.add(id(code))
                    yield from (each for each in code.endpoints if each.span.source.name.endswith(CPP))

    @cached_property
    def node_names(self) -> NodeNames:
        """The names of all nodes that anything of the tree starts, as far as they are known."""
        from bringup_lint.graph.topics.resolved.node_names import node_names

        return node_names(self)

    @property
    def named_nodes(self) -> Iterator[LaunchedNode]:
        """The launched nodes of which the name is known."""
        return (node for running in self.entries for node in running.nodes if node.name is not None)

    def of_source(self, source: Source) -> list[LaunchedNode]:
        """The launched nodes of the classes in a Python source."""
        return self._of_source.get(id(source), [])

    @cached_property
    def _of_source(self) -> dict[int, list[LaunchedNode]]:
        found: dict[int, list[LaunchedNode]] = {}
        for running in self.runs:
            for node in running.nodes:
                if node.node_class is not None:
                    found.setdefault(id(node.node_class.source), []).append(node)
        return found

    @property
    def missing_nodes(self) -> Iterator[Missing]:
        """Nodes that something watches or waits for and that nothing starts."""
        from bringup_lint.graph.topics.questions.watch_lists import missing
        from bringup_lint.graph.topics.questions.watch_lists import watched

        if self.robot.of_kind(*LAUNCH):
            for found in watched(self.robot):
                yield from missing(found, self.node_names)

    def cpp_mentions(self, pattern: re.Pattern[str]) -> bool:
        """Whether a C++ source of a launched program holds a pattern."""
        return any(pattern.search(source.text) for source in self._cpp.sources)

    @cached_property
    def published_anywhere(self) -> frozenset[str]:
        """The last parts of the names that any source of the tree publishes, started or not."""
        published = (each.name for each in self.endpoints if each.role == "publisher" and each.name)
        return frozenset(names.tail(str(name)) for name in published)

    @cached_property
    def pairs(self) -> list[Pair]:
        """Publishers and subscriptions of one topic that run together when launch files are started without arguments,
        each once."""
        found: dict[tuple, Pair] = {}
        for running in self.runs:
            for uses in running.by_topic().values():
                publishers = [use for use in uses if use.role == "publisher"][:COMPARED]
                subscriptions = [use for use in uses if use.role == "subscription"][:COMPARED]
                for publisher, subscription in product(publishers, subscriptions):
                    if together(publisher.node, subscription.node):
                        found.setdefault(_places(publisher, subscription), Pair(publisher, subscription))
        return list(found.values())


def _places(*uses: Use) -> tuple:
    return tuple((id(use.where.source), use.where.start, use.topic) for use in uses)


def load_topics(robot: Robot) -> Topics:
    return Topics(robot)
