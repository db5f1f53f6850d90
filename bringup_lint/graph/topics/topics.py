"""The topic layer: what every launched node publishes and subscribes, and which nodes run together."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property
from itertools import chain
from itertools import product
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.discover.starters import STARTING
from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.graph.memo import memo
from bringup_lint.graph.purpose import Purpose
from bringup_lint.graph.topics.questions.coexistence import coexist
from bringup_lint.graph.topics.questions.command_sources import has_stop_hardware
from bringup_lint.graph.topics.resolved import names
from bringup_lint.graph.topics.resolved.endpoint_use import LaunchedNode
from bringup_lint.graph.topics.resolved.endpoint_use import Pair
from bringup_lint.graph.topics.resolved.endpoint_use import Running
from bringup_lint.graph.topics.resolved.endpoint_use import Use
from bringup_lint.graph.topics.resolved.nodes import resolved_node
from bringup_lint.graph.topics.resolved.parameters import ParameterSources
from bringup_lint.graph.topics.resolved.remapping import refused_sides
from bringup_lint.graph.topics.resolved.systems import systems
from bringup_lint.graph.topics.sources.code import Code
from bringup_lint.graph.topics.sources.cpp_code import CppCode
from bringup_lint.graph.topics.sources.cpp_files import CppFiles
from bringup_lint.graph.topics.sources.programs import code_of
from bringup_lint.graph.topics.sources.rviz import Displays
from bringup_lint.graph.topics.sources.whole_programs import WholePrograms
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.topics.questions.static_transforms import Conflict
    from bringup_lint.graph.topics.questions.transform_sources import TransformSource
    from bringup_lint.graph.topics.questions.watch_lists import Missing
    from bringup_lint.graph.topics.questions.watch_lists import Watched
    from bringup_lint.graph.topics.resolved.node_names import NodeNames
    from bringup_lint.graph.topics.sources.parameter_names import ParameterNames
    from bringup_lint.model.node_source import Endpoint
    from bringup_lint.model.node_source import Parameter
    from bringup_lint.model.parameter_words import ParameterWords
    from bringup_lint.source import Located
    from bringup_lint.source import Source
    from bringup_lint.source import Span

COMPARED = 100
"""Publishers and subscriptions of one topic that are compared with each other."""
SPEAKING = ("python-node", "params", *LAUNCH, "udev-rules", "ros-package")
"""Kinds of files that may name the hardware of the robot."""


_WAITING = regex(
    r"\bwait_?for_?(?:action_?)?(?:server|service|message)|\bwait_for_transform|\bwaitUntilNav2Active|\bcan_?transform\b",
    re.I,
)


@dataclass(eq=False)
class Topics:
    """Asked as ``robot.topics``: the endpoints of what runs together, by the names that launch files give them."""

    files: Files
    launch: Launch
    nodes: Nodes
    params: Callable[[], Params]
    ros: Callable[[], RosEnvironment]
    units: Callable[[], Units]

    @cached_property
    def _cpp(self) -> CppCode:
        return CppCode(self.files, self._cpp_files, WholePrograms(self._cpp_files, self.launch.workspace))

    @cached_property
    def _cpp_files(self) -> CppFiles:
        return CppFiles(self.files, self.launch.workspace)

    @cached_property
    def _displays(self) -> Displays:
        return Displays(self.files, self.launch)

    @cached_property
    def entries(self) -> list[Running]:
        """What each launch file starts that no other one includes."""
        return [self._running(each.entry.source.name, [each]) for each in self.launch.entries]

    def code(self, started: Started) -> Code | None:
        """What the tree's sources say about a launched program."""
        program = (literal_text(started.package), literal_text(started.executable), literal_text(started.plugin))
        if program not in self._codes:
            self._codes[program] = code_of(started, self.nodes, self.launch.workspace, self._cpp)
        return self._codes[program]

    @cached_property
    def _codes(self) -> dict[tuple[str | None, ...], Code | None]:
        return {}

    def defaults(self, started: Started) -> dict[str, object]:
        """The literal defaults with which a launched program declares its parameters, as far as they are known."""
        code = self.code(started)
        if code is None:
            return {}
        if code.node_class is not None:
            declared = list(code.node_class.parameters.values())
        else:
            declared = [each for node in self.nodes.cpp if node.source is code.source for each in node.parameters]
        return {str(each.name): each.default for each in declared if each.known}

    def defaults_beside(self, started: Started) -> dict[str, object]:
        """The same of the other C++ sources that its program is made of, where they agree; not of what its own
        declares."""
        code, paths = self.code(started), self._parameter_names.sources_of(started)
        found: dict[str, list[Parameter]] = {}
        own: set[str] = set()
        for node in self.nodes.cpp:
            if code is not None and node.source is code.source:
                own = {str(each.name) for each in node.parameters}
            elif code is not None and node.source.absolute in paths:
                for each in node.parameters:
                    found.setdefault(str(each.name), []).append(each)
        return {
            name: first.default
            for name, (first, *others) in found.items()
            if name not in own and first.known and all(each.known and each.default == first.default for each in others)
        }

    def waits(self, started: Started) -> bool:
        """Whether the package of a launched program waits for a server, a message or a transform by itself."""
        return str(literal_text(started.package)) in self._waiting

    @cached_property
    def _waiting(self) -> set[str]:
        """The packages with a source that waits."""
        waiting = (each for each in self.files.of_kind("python-node", "cpp-node") if each.matches(_WAITING))
        owners = map(self.launch.workspace.owner, waiting)
        return {owner.name for owner in owners if owner is not None}

    def parameter_words(self, started: Started) -> ParameterWords | None:
        """The texts with which a launched program may name its parameters; None when not all of it is known."""
        return self._parameter_names.of(started)

    @property
    def all_parameter_words(self) -> Iterator[ParameterWords]:
        """The same for every program of the workspace of which it is known."""
        return self._parameter_names.all

    def may_be_declared_for(self, name: Located) -> bool:
        """Whether one of the nodes that import the file of a parameter's name may declare it."""
        return self._parameter_names.may_be_declared_for(name)

    @cached_property
    def _parameter_names(self) -> ParameterNames:
        from bringup_lint.graph.topics.sources.parameter_names import ParameterNames

        return ParameterNames(self.files, self.launch.workspace, self.nodes, self._cpp_files)

    @memo
    def node(self, started: Started) -> LaunchedNode:
        """What launch makes of a node: its name, its parameters, and the topics that it uses."""
        return resolved_node(started, self.code(started), self._displays.of(started), self.parameter_sources)

    @cached_property
    def parameter_sources(self) -> ParameterSources:
        return ParameterSources(self.launch, self.params)

    @cached_property
    def runs(self) -> list[Running]:
        """What runs together: each entry alone, and all that the units of one boot or one compose file launch."""
        return [*self._systems(), *self.entries]

    def _systems(self) -> list[Running]:
        if not self.files.of_kind(*STARTING):
            return []
        found = systems(self.ros(), self.units)
        return [self._running(each.label, each.expansions, whole=each.whole) for each in found]

    def _running(self, label: str, expansions: list[Expansion], *, whole: bool = False) -> Running:
        running = Running(label)
        started = [each for expansion in expansions for each in expansion.nodes]
        running.nodes = [self.node(each) for each in started if each.is_node]
        known = all(each.is_node for each in started) and not any(expansion.open for expansion in expansions)
        running.complete = known and all(node.complete for node in running.nodes)
        running.whole = running.complete and whole
        running.simulated = any(self.launch.simulated(expansion.entry) for expansion in expansions)
        return running

    def is_given(self, parameter: str) -> bool:
        """Whether a parameter file, launch file or command of the tree names a parameter, for whatever node."""
        kinds = (*STARTING, *LAUNCH, "params", "shell-script")
        return any(parameter in source.text for source in self.files.of_kind(*kinds))

    def is_always_given(self, source: Source, parameter: str) -> bool:
        """Whether launch files start programs of the package of a source that may ask for a parameter, and give it to
        all of them, as far as is known."""
        owner = self.launch.workspace.owner(source)
        started = [each for each in self.launch.nodes if owner and literal_text(each.package) == owner.name]
        words = ((each, self.parameter_words(each)) for each in started)
        given = [self.node(each).given for each, known in words if known is None or known.name(parameter)]
        return bool(given) and all(each is None or each.open or parameter in each.values for each in given)

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
        """Every endpoint in the sources of nodes, of tests none."""
        for node in self.nodes.classes:
            if self.nodes.purpose(node.source) is not Purpose.TEST:
                yield from node.endpoints
        for source in self.nodes.cpp:
            yield from source.endpoints

    @cached_property
    def node_names(self) -> NodeNames:
        """The names of all nodes that anything of the tree starts, as far as they are known."""
        from bringup_lint.graph.topics.resolved.node_names import node_names

        return node_names(self.launch, self.ros(), self.node, self.code)

    @property
    def named_nodes(self) -> Iterator[LaunchedNode]:
        """The launched nodes of which the name is known."""
        return (node for running in self.entries for node in running.nodes if node.name is not None)

    def of_source(self, source: Source) -> list[LaunchedNode]:
        """The launched nodes of the classes in a Python source."""
        return self._of_source.get(source, [])

    @cached_property
    def _of_source(self) -> dict[Source, list[LaunchedNode]]:
        found: dict[Source, list[LaunchedNode]] = {}
        for running in self.runs:
            for node in running.nodes:
                if node.node_class is not None:
                    found.setdefault(node.node_class.source, []).append(node)
        return found

    @property
    def rival_transforms(self) -> Iterator[tuple[TransformSource, TransformSource]]:
        """Two that surely run together and publish one transform of the robot."""
        from bringup_lint.graph.topics.questions.transform_sources import rival_transforms

        for running in self.runs:
            yield from rival_transforms(running, self.parameter_sources)

    @property
    def conflicting_transforms(self) -> Iterator[Conflict]:
        """Frames that a static transform and a robot description of what surely runs together put in two places, each
        once."""
        from bringup_lint.graph.topics.questions.static_transforms import conflicting_transforms

        real = (running for running in self.runs if not running.simulated)
        every = chain.from_iterable(conflicting_transforms(self.launch, self.files.tree, each) for each in real)
        yield from {(found.static.where, found.static.child): found for found in every}.values()

    @property
    def missing_nodes(self) -> Iterator[Missing]:
        """Nodes that something watches or waits for and that nothing starts."""
        from bringup_lint.graph.topics.questions.watch_lists import WatchLists
        from bringup_lint.graph.topics.questions.watch_lists import missing

        if not self.files.of_kind(*LAUNCH):
            return
        lists = list(WatchLists(self.files, self.nodes, self.params, self._given_to).all())
        naming = self._naming(lists)
        for found in lists:
            yield from missing(found, self.node_names, naming)

    def _naming(self, lists: Iterable[Watched]) -> Counter[str]:
        """How many places call a node so: those that start it, those that watch it, those that give it parameters."""
        places = {name.span: str(name) for found in lists for name in found.names}
        places |= {node.started.span: str(node.name) for node in self.named_nodes}
        places |= {block.key.span: str(block.key) for file in self.params().judged for block in file.blocks}
        return Counter(names.tail(name) for name in places.values())

    def _given_to(self, source: Source) -> set[str]:
        """The names of the parameters that launch files give to the nodes of a source."""
        given = (node.given for node in self.of_source(source) if node.given is not None)
        return {name for parameters in given for name in parameters.values}

    @property
    def has_stop_hardware(self) -> bool:
        """Whether anything of the tree speaks of hardware that may stop the robot."""
        return has_stop_hardware((*self.files.of_kind(*SPEAKING), *self._cpp.sources))

    @cached_property
    def published_anywhere(self) -> frozenset[str]:
        """The last parts of the names that any source of the tree, or any program that a launch file starts, publishes,
        running or not."""
        published = [str(each.name) for each in self.endpoints if each.role == "publisher" and each.name]
        known = (self.launch.role(started).topics for started in self.launch.nodes)
        return frozenset(names.tail(name) for name in chain(published, *known))

    @cached_property
    def pairs(self) -> list[Pair]:
        """Publishers and subscriptions of one topic that run together when launch files are started without arguments,
        each once."""
        found: dict[tuple[tuple[Span, str], ...], Pair] = {}
        for running in self.runs:
            for uses in running.by_topic().values():
                publishers = [use for use in uses if use.role == "publisher"][:COMPARED]
                subscriptions = [use for use in uses if use.role == "subscription"][:COMPARED]
                for publisher, subscription in product(publishers, subscriptions):
                    if coexist(publisher.node, subscription.node):
                        found.setdefault(_places(publisher, subscription), Pair(publisher, subscription))
        return list(found.values())


def _places(*uses: Use) -> tuple[tuple[Span, str], ...]:
    return tuple((use.where, use.topic) for use in uses)
