"""The environment that launch gives to a process: that of the launch process itself, then every change in order.

launch: actions/set_environment_variable.py, append_environment_variable.py, descriptions/executable.py (``env`` starts
from nothing, ``additional_env`` is added to either).
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import Process
from bringup_lint.model.launch import SetEnv
from bringup_lint.model.launch import walk_actions
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import Literal
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.scope import EnvChange
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.model.launch import Action
    from bringup_lint.model.launch_values import Value


class Launched(NamedTuple):
    """A process that a launch file starts when nothing else is asked for."""

    node: Started
    environment: Environment
    expansion: Expansion
    """The launch file that was given to ``ros2 launch``, with all that it leads to."""


def launched_environment(base: Environment, node: Started) -> Environment:
    """The environment of a process that a launch file starts; ``base`` is that of the launch process."""
    result = Environment() if node.own_env else base.copy()
    for name, changes in node.env.items():
        for change in changes:
            _apply(result, name, change, base)
    result.complete &= not node.action.open
    return result


def _apply(result: Environment, name: str, change: EnvChange, base: Environment) -> None:
    if change.value is None:
        if change.certain:
            result.unset(name)
        elif name in result:
            result.set(Variable(name, Located(change.span.text, change.span), None, change.origin))
        return
    text = text_in(change.value, base)
    if change.mode != "set":
        text = _extended(result, name, change, text)
    result.set(Variable(name, _place(change.value), text if change.certain else None, change.origin))


def _extended(result: Environment, name: str, change: EnvChange, text: str | None) -> str | None:
    if result.defines(name) is False:
        return text
    before = result.text(name)
    separator = ":" if change.separator is None else text_of(change.separator)
    if before is None or text is None or separator is None:
        return None
    return separator.join((before, text) if change.mode == "append" else (text, before))


def text_in(value: Value, environment: Environment) -> str | None:
    """The text of a value when the launch process has this environment; None when that is not known."""
    if isinstance(value, Concat):
        texts = [text_in(part, environment) for part in value.parts]
        known = [text for text in texts if text is not None]
        return "".join(known) if len(known) == len(texts) else None
    if isinstance(value, Env):
        if environment.defines(str(value.name)) is False:
            return None if value.default is None else text_in(value.default, environment)
        return environment.text(str(value.name))
    return text_of(value)


def launch_variables(launch: Launch) -> Iterator[Variable]:
    """Every variable that launch files set to a text that is known, whether or not its process is started."""
    resolver = Resolver(Scope())
    for file in launch.judged:
        for action in walk_actions(file.actions):
            for origin, name, value in _pairs(action):
                named, text = text_of(resolver.value(name)), text_of(resolver.value(value))
                if named is not None and text is not None:
                    yield Variable(named, _place(resolver.value(value)), text, origin)


def _pairs(action: Action) -> Iterator[tuple[str, Value, Value]]:
    if isinstance(action, SetEnv) and action.mode == "set":
        yield "SetEnvironmentVariable", action.name, action.value
    elif isinstance(action, Process):
        for origin, pairs in (("env", action.env or ()), ("additional_env", action.additional_env)):
            yield from ((origin, name, value) for name, value in pairs)


def _place(value: Value) -> Located:
    """The value as it is written."""
    if isinstance(value, Literal):
        return value.text
    return Located(value.span.text, value.span)


def launched(expansion: Expansion, base: Environment) -> Iterator[Launched]:
    """Every process of a launch file that surely starts; components live in the process of their container."""
    for node in expansion.nodes:
        if node.by_default is True and not isinstance(node.action, ComposableNode):
            yield Launched(node, launched_environment(base, node) if node.env or node.own_env else base, expansion)


def alike(found: Iterable[Launched], names: re.Pattern[str]) -> dict[tuple, list[Launched]]:
    """The processes in groups that see the same variables, as far as ``names`` goes."""
    groups: dict[tuple, list[Launched]] = {}
    for each in found:
        groups.setdefault(view(each.environment, names), []).append(each)
    return groups


def view(environment: Environment, names: re.Pattern[str]) -> tuple:
    """What there is to see of an environment, as far as ``names`` goes: equal for equal texts from equal places."""
    chains = ((name, chain) for name, chain in environment.chains.items() if names.fullmatch(name))
    places = ((name, tuple((each.text, each.value.span) for each in chain)) for name, chain in chains)
    return (environment.complete, *sorted(places, key=lambda pair: pair[0]))
