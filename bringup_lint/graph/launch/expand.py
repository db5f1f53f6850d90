"""What a launch file starts: its actions visited in launch's order, through includes, groups and handlers."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import field
from functools import cached_property
from typing import Any
from typing import NamedTuple

from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.scope import Binding
from bringup_lint.graph.launch.scope import EnvChange
from bringup_lint.graph.launch.scope import EnvChanges
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.graph.launch.scope import later
from bringup_lint.graph.launch.scope import perhaps
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import started
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import EventHandler
from bringup_lint.model.launch import Group
from bringup_lint.model.launch import Include
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import LoadComponents
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Opaque
from bringup_lint.model.launch import Other
from bringup_lint.model.launch import Process
from bringup_lint.model.launch import PushNamespace
from bringup_lint.model.launch import Scope as ScopeAction
from bringup_lint.model.launch import SetArgument
from bringup_lint.model.launch import SetEnv
from bringup_lint.model.launch import SetParameter
from bringup_lint.model.launch import SetParametersFromFile
from bringup_lint.model.launch import SetRemap
from bringup_lint.model.launch import Timer
from bringup_lint.model.launch import UnsetArgument
from bringup_lint.model.launch import UnsetEnv
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import children
from bringup_lint.model.launch_values import same
from bringup_lint.parsers.launch_python.budget import bounded
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

DEPTH = 16
"""Includes inside one another."""
ACTIONS = 20_000
"""Actions of one entry."""


class Included(NamedTuple):
    """An include as it happens: the target is None when the file is not in the tree."""

    action: Include
    file: Value
    source: LaunchFile
    target: LaunchFile | None
    arguments: dict[str, Value]
    conditions: tuple[Condition, ...]
    chain: tuple[Span, ...]
    known: frozenset[str]
    """The launch configurations that exist before the include, without those that it passes."""


class Declared(NamedTuple):
    """A declaration as it happens."""

    action: DeclareArgument
    file: LaunchFile
    name: str
    before: Binding | None
    """The value that the configuration already had, so that the default is not used."""
    conditions: tuple[Condition, ...]
    chain: tuple[Span, ...]


class Used(NamedTuple):
    """A launch configuration that does not exist where it is read."""

    argument: Argument
    file: LaunchFile
    chain: tuple[Span, ...]
    conditions: tuple[Condition, ...]
    certain: bool
    """Nothing before it could have set the configuration unseen."""


@dataclass(eq=False)
class Expansion:
    """Everything that one entry leads to."""

    entry: LaunchFile
    nodes: list[Started] = field(default_factory=list)
    """Nodes, components and other processes, in the order in which they start."""
    includes: list[Included] = field(default_factory=list)
    declared: list[Declared] = field(default_factory=list)
    unbound: list[Used] = field(default_factory=list)
    handlers: list[tuple[EventHandler, LaunchFile]] = field(default_factory=list)
    actions: list[tuple[Action, LaunchFile]] = field(default_factory=list)
    """Every action that was visited."""
    cycle: list[Included] = field(default_factory=list)
    """Includes that come back to a file that is still being read."""
    open: bool = False
    """Something is not understood or not in the tree: more may start, and more arguments may be read."""
    arguments: dict[str, Binding] = field(default_factory=dict)
    """The launch configurations at the end."""

    @cached_property
    def files(self) -> list[LaunchFile]:
        """Every file that is read; ask only when the expansion is done."""
        found = {id(file): file for _, file in self.actions}
        found.setdefault(id(self.entry), self.entry)
        return list(found.values())


def both(first: bool | None, second: bool | None) -> bool | None:
    """``and`` for outcomes that may be unknown."""
    return False if False in (first, second) else (None if None in (first, second) else True)


class Expander:
    """``locate`` gives the launch file that a resolved value names, or None."""

    def __init__(self, entry: LaunchFile, locate: Callable[[Value], LaunchFile | None]) -> None:
        self.result = Expansion(entry)
        self.locate = locate
        self.scope = Scope()
        self.pushed: dict[str, list[Scope]] = {}
        """What ``PushEnvironment`` and ``PushLaunchConfigurations`` keep."""
        self.delayed: list[tuple[Started, dict[str, EnvChanges]]] = []
        """What timers and handlers start, with the environment in which they were set up."""
        self.changed_later: set[str] = set()
        """The variables that timers and handlers change."""
        self.file = entry
        self.conditions: tuple[Condition, ...] = ()
        """Open ones, in terms of what the user may pass."""
        self.by_default: bool | None = True
        """Whether the current action happens when no argument is passed."""
        self.chain: tuple[Span, ...] = ()
        self.open_files: list[Source] = [entry.source]
        self.context: tuple[Action, ...] = ()
        """The timers and handlers around."""
        self.count = 0
        self.containers: dict[int, Started] = {}

    def run(self, arguments: dict[str, Value]) -> Expansion:
        for name, value in arguments.items():
            self.scope.arguments[name] = Binding(value, value, value.span, False)
        self.visit(self.file.actions)
        self.result.arguments = self.scope.arguments
        for node, before in self.delayed:
            if not node.own_env:
                node.env = later(node.env, before, self.scope.env, self.changed_later)
        return self.result

    def visit(self, actions: Iterable[Action]) -> None:
        for action in actions:
            self.count += 1
            if self.count > ACTIONS:
                self.result.open = True
                return
            self.action(action)

    def action(self, action: Action) -> None:
        resolver, symbolic = Resolver(self.scope), Resolver(self.scope, symbolic=True)
        outer, by_default, scope = self.conditions, self.by_default, self.scope
        left: list[Condition] = []
        for condition in action.conditions:
            self.note_unbound(condition.predicate)
            predicate = bounded(symbolic.value(condition.predicate))
            sharper = Condition(predicate, condition.wanted, condition.kind, condition.span)
            outcome = symbolic.holds(condition)
            if outcome is False:
                return
            if outcome is None:
                left.append(sharper)
        self.conditions = (*outer, *left)
        own = resolver.all_hold(action.conditions)
        self.by_default = both(by_default, own)
        self.result.actions.append((action, self.file))
        handler = _ACTIONS.get(type(action))
        if handler is not None:
            if own is False:
                self.scope = scope.copy()
                resolver, symbolic = Resolver(self.scope), Resolver(self.scope, symbolic=True)
            env = dict(self.scope.env) if own is None else None
            handler(self, action, resolver, symbolic)
            if own is False:
                self.scope = scope
            elif env is not None:
                self.scope.env = perhaps(env, self.scope.env)
        self.conditions, self.by_default = outer, by_default

    def note_unbound(self, *values: Value | None) -> None:
        """Remember configurations that are read here and do not exist."""
        todo = [value for value in values if value is not None]
        while todo:
            value = todo.pop()
            if isinstance(value, Argument):
                if value.default is None and str(value.name) not in self.scope.arguments:
                    self.result.unbound.append(
                        Used(value, self.file, self.chain, self.conditions, not self.result.open)
                    )
                continue
            todo.extend(children(value))

    def bind(self, name: str, value: Value, symbol: Value, origin: Span, declared: bool = False) -> None:
        """Set a launch configuration; under an open condition it may keep what it was."""
        before = self.scope.arguments.get(name)
        if self.by_default is None and before is not None and not same(before.value, value):
            value = bounded(Choice((((), before.value), (self.conditions, value)), origin))
        if self.conditions and before is not None and not same(before.symbol, symbol):
            symbol = bounded(Choice((((), before.symbol), (self.conditions, symbol)), origin))
        self.scope.arguments[name] = Binding(bounded(value), bounded(symbol), origin, declared)

    def scoped(self, scope: Scope, actions: Iterable[Action]) -> None:
        outer, self.scope = self.scope, scope
        self.visit(actions)
        self.scope = outer

    def inside(self, action: Action, actions: Iterable[Action]) -> None:
        """Actions that happen later, in a timer or handler: with the environment that is there at the end."""
        outer, self.context = self.context, (*self.context, action)
        before, first = dict(self.scope.env), len(self.result.nodes)
        self.visit(actions)
        self.context = outer
        self.delayed += [(node, before) for node in self.result.nodes[first:]]
        self.changed_later |= {name for name, changes in self.scope.env.items() if changes is not before.get(name)}
        self.scope.env = dict(before)

    def start(self, node: Any, container: Started | None = None) -> Started:
        resolver = Resolver(self.scope)
        result = started(node, self.file, self.scope, resolver, self.conditions, self.chain, self.context, container)
        result.by_default = self.by_default
        self.result.nodes.append(result)
        return result

    def components(self: Expander, nodes: Iterable[Action], container: Started | None) -> None:
        outer, by_default = self.conditions, self.by_default
        for node in nodes:
            if not isinstance(node, ComposableNode):
                self.result.open = True
                continue
            symbolic = Resolver(self.scope, symbolic=True)
            outcomes = [(condition, symbolic.holds(condition)) for condition in node.conditions]
            if any(outcome is False for _, outcome in outcomes):
                continue
            self.conditions = (*outer, *(condition for condition, outcome in outcomes if outcome is None))
            self.by_default = both(by_default, Resolver(self.scope).all_hold(node.conditions))
            remapped = [value for pair in node.remappings for value in pair]
            self.note_unbound(node.package, node.plugin, node.name, node.namespace, *node.parameters, *remapped)
            self.start(node, container)
            self.conditions, self.by_default = outer, by_default


def _declare(self: Expander, action: DeclareArgument, resolver: Resolver, symbolic: Resolver) -> None:
    name = text_of(resolver.value(action.name))
    if name is None:
        self.result.open = True
        return
    before = self.scope.arguments.get(name)
    self.result.declared.append(Declared(action, self.file, name, before, self.conditions, self.chain))
    self.note_unbound(action.default)
    if before is not None:
        return
    span = action.span
    if action.default is None:
        missing = Argument(_named(action, name), None, span)
        self.scope.arguments[name] = Binding(missing, missing, span, True)
        return
    default = resolver.value(action.default)
    symbol = Argument(_named(action, name), default, span)
    self.scope.arguments[name] = Binding(bounded(default), bounded(symbol), span, True)


def _named(action: DeclareArgument, name: str) -> Located:
    return Located(name, action.name.span)


def _set(self: Expander, action: SetArgument, resolver: Resolver, symbolic: Resolver) -> None:
    name = text_of(resolver.value(action.name))
    self.note_unbound(action.value)
    if name is None:
        self.result.open = True
        return
    self.bind(name, resolver.value(action.value), symbolic.value(action.value), action.span)


def _unset(self: Expander, action: UnsetArgument, resolver: Resolver, symbolic: Resolver) -> None:
    name = None if action.name is None else text_of(resolver.value(action.name))
    if self.conditions:
        return
    if action.name is None:
        self.scope.arguments.clear()
    elif name is not None:
        self.scope.arguments.pop(name, None)


def _include(self: Expander, action: Include, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.file, *(value for _, value in action.arguments))
    file = resolver.value(action.file)
    target = self.locate(file)
    known = frozenset(self.scope.arguments)
    passed: dict[str, Value] = {}
    chain = (*self.chain, action.span)
    for name_value, value in action.arguments:
        name = text_of(resolver.value(name_value))
        if name is None:
            self.result.open = True
            continue
        passed[name] = value
        own = Resolver(self.scope)
        self.bind(name, own.value(value), Resolver(self.scope, symbolic=True).value(value), value.span)
    included = Included(action, file, self.file, target, passed, self.conditions, chain, known)
    self.result.includes.append(included)
    if action.open or target is None:
        self.result.open = True
    if target is None:
        return
    if target.source in self.open_files:
        self.result.cycle.append(included)
        return
    if len(self.chain) >= DEPTH:
        self.result.open = True
        return
    outer_file, outer_chain = self.file, self.chain
    self.file, self.chain = target, chain
    self.open_files.append(target.source)
    self.visit(target.actions)
    self.open_files.pop()
    self.file, self.chain = outer_file, outer_chain


def _group(self: Expander, action: Group, resolver: Resolver, symbolic: Resolver) -> None:
    scoped = True if action.scoped is None else truth(resolver.value(action.scoped))
    forwarding = True if action.forwarding is None else truth(resolver.value(action.forwarding))
    inner = self.scope
    if scoped is not False:
        inner = self.scope.copy() if forwarding is not False else self.scope.cleared()
    outer, self.scope = self.scope, inner
    for name_value, value in action.arguments:
        name = text_of(resolver.value(name_value))
        if name is not None:
            self.bind(name, resolver.value(value), symbolic.value(value), value.span)
    self.visit(action.actions)
    self.scope = outer


def _scope(self: Expander, action: ScopeAction, resolver: Resolver, symbolic: Resolver) -> None:
    stack = self.pushed.setdefault(action.what, [])
    if action.push:
        stack.append(self.scope.copy())
    elif stack and action.what == "environment":
        self.scope.env = stack.pop().env
    elif stack:
        env, self.scope = self.scope.env, stack.pop()
        self.scope.env = env


def _env(self: Expander, action: SetEnv, resolver: Resolver, symbolic: Resolver) -> None:
    name = text_of(resolver.value(action.name))
    self.note_unbound(action.value)
    if name is not None:
        value, separator = resolver.value(action.value), resolver.optional(action.separator)
        origin = "SetEnvironmentVariable" if action.mode == "set" else "AppendEnvironmentVariable"
        self.scope.change(name, EnvChange(value, origin, action.span, action.mode, separator))


def _unset_env(self: Expander, action: UnsetEnv, resolver: Resolver, symbolic: Resolver) -> None:
    if action.name is None:
        self.scope.env.clear()
        return
    name = text_of(resolver.value(action.name))
    if name is not None:
        self.scope.change(name, EnvChange(None, "UnsetEnvironmentVariable", action.span))


def _namespace(self: Expander, action: PushNamespace, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.namespace)
    value = resolver.value(action.namespace)
    if self.by_default is None:
        value = Choice(((self.conditions, value),), action.span)
    self.scope.namespaces = (*self.scope.namespaces, value)


def _remap(self: Expander, action: SetRemap, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.src, action.dst)
    self.scope.remaps = (*self.scope.remaps, (resolver.value(action.src), resolver.value(action.dst)))


def _parameter(self: Expander, action: SetParameter, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.value)
    pair = (resolver.value(action.name), resolver.value(action.value))
    self.scope.parameters = (*self.scope.parameters, DictValue((pair,), action.span))


def _parameter_file(self: Expander, action: SetParametersFromFile, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.file)
    file = ParameterFile(resolver.value(action.file), None, action.span)
    self.scope.parameters = (*self.scope.parameters, file)


def _process(self: Expander, action: Process, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.name, *action.cmd, *action.options.values())
    self.start(action)
    self.inside(action, action.on_exit)


def _node(self: Expander, action: Node, resolver: Resolver, symbolic: Resolver) -> None:
    remapped = [value for pair in action.remappings for value in pair]
    named = (action.package, action.executable, action.name, action.namespace)
    self.note_unbound(*named, *action.parameters, *action.arguments, *remapped, *action.options.values())
    container = self.start(action)
    self.containers[action.key] = container
    self.components(action.components, container)
    self.inside(action, action.on_exit)


def _load(self: Expander, action: LoadComponents, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.target)
    container = self.containers.get(action.target_key) if action.target_key is not None else None
    self.components(action.components, container)


def _timer(self: Expander, action: Timer, resolver: Resolver, symbolic: Resolver) -> None:
    self.note_unbound(action.period)
    self.inside(action, action.actions)


def _handler(self: Expander, action: EventHandler, resolver: Resolver, symbolic: Resolver) -> None:
    self.result.handlers.append((action, self.file))
    self.inside(action, action.actions)


def _opaque(self: Expander, action: Opaque, resolver: Resolver, symbolic: Resolver) -> None:
    self.visit(action.actions)


def _other(self: Expander, action: Other, resolver: Resolver, symbolic: Resolver) -> None:
    self.result.open = True
    self.visit(action.actions)


_ACTIONS: dict[type[Action], Callable[[Expander, Any, Resolver, Resolver], None]] = {
    DeclareArgument: _declare,
    SetArgument: _set,
    UnsetArgument: _unset,
    Include: _include,
    Group: _group,
    ScopeAction: _scope,
    SetEnv: _env,
    UnsetEnv: _unset_env,
    PushNamespace: _namespace,
    SetRemap: _remap,
    SetParameter: _parameter,
    SetParametersFromFile: _parameter_file,
    Process: _process,
    Node: _node,
    LoadComponents: _load,
    Timer: _timer,
    EventHandler: _handler,
    Opaque: _opaque,
    Other: _other,
}
