"""What launch does with each kind of action, in the context of an expansion."""

from __future__ import annotations

import os

from bringup_lint.facts.ros.launch_arguments import taken
from bringup_lint.graph.launch.expand import Expander
from bringup_lint.graph.launch.expand import Visit
from bringup_lint.graph.launch.expansion import Declared
from bringup_lint.graph.launch.expansion import Included
from bringup_lint.graph.launch.expansion import Loaded
from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.resolve import truth
from bringup_lint.graph.launch.scope import Binding
from bringup_lint.graph.launch.scope import EnvChange
from bringup_lint.graph.workspace import place
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import EventHandler
from bringup_lint.model.launch import Group
from bringup_lint.model.launch import Include
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
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ParameterFile
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import bounded
from bringup_lint.source import Located

DEPTH = 16
"""Includes inside one another."""


def _declare(self: Expander, action: DeclareArgument, resolver: Resolver, symbolic: Resolver) -> None:
    name = text_of(resolver.value(action.name))
    if name is None:
        self.result.opaque = True
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
        self.result.opaque = True
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
    self.note_unbound(action.file)
    file = resolver.value(action.file)
    target = self.locate(file)
    known = frozenset(self.scope.arguments)
    passed: dict[str, Value] = {}
    values: dict[str, Value] = {}
    chain = (*self.chain, action.span)
    for name_value, value in action.arguments:
        self.note_unbound(value)  # launch sets one argument after the other: each may read those before it
        name = text_of(resolver.value(name_value))
        if name is None:
            self.result.opaque = True
            continue
        passed[name] = value
        values[name] = Resolver(self.scope).value(value)
        self.bind(name, values[name], Resolver(self.scope, symbolic=True).value(value), value.span)
    included = Included(action, file, self.file, target, passed, values, self.conditions, chain, known, self.context)
    self.result.includes.append(included)
    if action.open:
        self.result.opaque = True
    if target is None:
        _leave(self, file)
        return
    if target.source in self.open_files:
        self.result.cycle.append(included)
        return
    if len(self.chain) >= DEPTH:
        self.result.opaque = True
        return
    outer_file, outer_chain = self.file, self.chain
    self.file, self.chain = target, chain
    self.open_files.append(target.source)
    self.visit(target.actions)
    self.open_files.pop()
    self.file, self.chain = outer_file, outer_chain


def _leave(self: Expander, file: Value) -> None:
    where = place(file)
    known = taken(where.package, os.path.basename(where.path)) if where is not None and where.base == "share" else None
    self.result.leaves_tree = True
    if known is None or known.grows:
        self.result.is_lost = True
    else:
        self.result.outside |= known.arguments


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
    target = resolver.optional(action.target)
    self.result.loads.append(Loaded(action, target, self.file, self.conditions, self.by_default))
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
    self.result.opaque = True
    self.visit(action.actions)


VISITS: dict[type[Action], Visit] = {
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
