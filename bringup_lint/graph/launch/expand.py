"""What a launch file starts: its actions visited in launch's order, through includes, groups and handlers."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Mapping
from typing import Any

from bringup_lint.graph.launch.expansion import Expansion
from bringup_lint.graph.launch.expansion import Failed
from bringup_lint.graph.launch.expansion import Used
from bringup_lint.graph.launch.python_expression import failure
from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.scope import Binding
from bringup_lint.graph.launch.scope import EnvChanges
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.graph.launch.scope import later
from bringup_lint.graph.launch.scope import perhaps
from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import started
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import bounded
from bringup_lint.model.launch_values import children
from bringup_lint.model.launch_values import same
from bringup_lint.model.launch_values import walk
from bringup_lint.source import Source
from bringup_lint.source import Span

ACTIONS = 20_000
"""Actions of one entry."""


def both(first: bool | None, second: bool | None) -> bool | None:
    """``and`` for outcomes that may be unknown."""
    return False if False in (first, second) else (None if None in (first, second) else True)


Visit = Callable[["Expander", Any, Resolver, Resolver], None]
"""What one kind of action does: it gets the action, and the values as they are and in terms of the arguments."""


class Expander:
    """Walks through the actions of one entry. ``visits`` says what each kind of action does, ``locate`` gives the
    launch file that a resolved value names, or None; more than ``limit`` actions are left out."""

    def __init__(
        self,
        entry: LaunchFile,
        visits: Mapping[type[Action], Visit],
        locate: Callable[[Value], LaunchFile | None],
        limit: int = ACTIONS,
    ) -> None:
        self.result = Expansion(entry)
        self.visits = visits
        self.locate = locate
        self.limit = limit
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
        self.not_by_default: dict[str, list[tuple[Condition, ...]]] = {}
        """The conditions of what declares or sets a configuration and does not happen by default."""

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
            if self.count > self.limit:
                self.result.opaque = True
                return
            self.action(action)

    def action(self, action: Action) -> None:
        resolver, symbolic = Resolver(self.scope), Resolver(self.scope, symbolic=True)
        outer, by_default, scope = self.conditions, self.by_default, self.scope
        left: list[Condition] = []
        for condition in action.conditions:
            self.note_unbound(condition.predicate)
            self.note_failed(condition, resolver)
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
        handler = self.visits.get(type(action))
        if handler is not None:
            if own is False:
                self.scope = scope.copy()
                resolver, symbolic = Resolver(self.scope), Resolver(self.scope, symbolic=True)
            env = dict(self.scope.env) if own is None else None
            handler(self, action, resolver, symbolic)
            if own is False:
                for name in self.scope.arguments.keys() - scope.arguments.keys():
                    self.not_by_default.setdefault(name, []).append(self.conditions)
                self.scope = scope
            elif env is not None:
                self.scope.env = perhaps(env, self.scope.env)
        self.conditions, self.by_default = outer, by_default

    def note_failed(self, condition: Condition, resolver: Resolver) -> None:
        """Remember Python expressions that raise an exception here."""
        if condition.kind not in ("if", "unless") or self.by_default is False:
            return
        for part in walk(condition.predicate):
            if not isinstance(part, Operation) or part.name != "python":
                continue
            text = text_of(resolver.value(part.operands[0]))
            error = failure(text) if text is not None else None
            if text is not None and error is not None:
                names = frozenset(str(each.name) for each in walk(part) if isinstance(each, Argument))
                self.result.failed.append(Failed(part.span, text, error, names, self.file, self.by_default, self.chain))

    def note_unbound(self, *values: Value | None) -> None:
        """Remember configurations that are read here and do not exist."""
        todo = [value for value in values if value is not None]
        while todo:
            value = todo.pop()
            if isinstance(value, Argument):
                if value.default is None and not self.exists(str(value.name)):
                    self.result.unbound.append(
                        Used(value, self.file, self.chain, self.conditions, self.is_unset(str(value.name)))
                    )
                continue
            todo.extend(children(value))

    def exists(self, name: str) -> bool:
        """Whether a configuration is there, here and whenever what comes here happens."""
        if name in self.scope.arguments:
            return True
        return any(all(map(self.under, needed)) for needed in self.not_by_default.get(name, ()))

    def is_unset(self, name: str) -> bool:
        """Whether nothing so far may have set a configuration unseen."""
        return not self.result.opaque and not self.result.is_lost and name not in self.result.outside

    def under(self, condition: Condition) -> bool:
        """Whether a condition holds here."""
        alike = (each for each in self.conditions if each.wanted == condition.wanted)
        return any(same(each.predicate, condition.predicate) for each in alike)

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
                self.result.opaque = True
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
