"""Python's truth of an object: True, False, or the condition that decides it at run time."""

from __future__ import annotations

from typing import Any

from bringup_lint.model.launch_values import VALUE_TYPES
from bringup_lint.model.launch_values import Argument
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Command
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import PackagePrefix
from bringup_lint.model.launch_values import PackageShare
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Unknown
from bringup_lint.model.launch_values import Value
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.containers import presence
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.unperformed import note_object
from bringup_lint.source import Span

_ALWAYS = (PackageShare, PackagePrefix, PathJoin, Command)


def truth(state: State, thing: Any, where: Span) -> bool | Value:
    """A bool when it is known, else the value whose truth it is."""
    if isinstance(thing, Literal):
        return bool(thing.value)
    if isinstance(thing, Sequence):
        if any(not guards for guards, _ in thing.items):
            return True
        return Unknown("list length", where) if thing.items or thing.open else False
    if isinstance(thing, Mapping):
        if any(presence(value) == () for _, value in thing.pairs()):
            return True
        return Unknown("dictionary", where) if thing.pairs() or thing.open else False
    if isinstance(thing, Argument):
        return Operation("!=", (thing, Literal("", where)), where) if thing.performed else True
    if isinstance(thing, Env):
        return Unknown("environment", where) if not thing.scoped else True
    if isinstance(thing, Options):
        outcomes = {truth(state, option, where) is True for _, option in thing.options}
        known = all(isinstance(truth(state, option, where), bool) for _, option in thing.options)
        return outcomes.pop() if known and len(outcomes) == 1 else freeze.value(state, thing)
    if isinstance(thing, (Operation, Choice, Unknown)):
        return thing
    if isinstance(thing, _ALWAYS):
        return True
    if isinstance(thing, VALUE_TYPES):
        return Unknown("text", where)
    return True


def negated(condition: Condition) -> Condition:
    return Condition(condition.predicate, not condition.wanted, condition.kind, condition.span)


def unless(guards: Guards) -> Condition:
    """That not all of some conditions hold."""
    if len(guards) == 1:
        return negated(guards[0])
    return Condition(Unknown("one of several conditions", guards[-1].span), True, "python", guards[-1].span)


def branch(state: State, thing: Any, where: Span) -> bool | Condition:
    """What an ``if`` does: a known outcome, or the condition of its body."""
    note_object(state, "condition", thing, where)
    outcome = truth(state, thing, where)
    return outcome if isinstance(outcome, bool) else Condition(outcome, True, "python", where)
