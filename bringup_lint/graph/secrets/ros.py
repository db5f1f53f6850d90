"""Secrets in parameter files and launch files: in clear text, or put into a parameter that everybody may ask for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.model.launch import Action
    from bringup_lint.model.launch_values import Value
    from bringup_lint.model.params import Parameter
    from bringup_lint.robot import Robot

USERS = ("user", "username", "user_name", "login")


class Named(NamedTuple):
    """A value of a parameter, argument or variable, with its name."""

    name: str
    value: Located
    holder: str
    """``params`` or ``launch``."""
    public: bool = False
    """The same word as the user name beside it: an account for everybody."""


class Indirect(NamedTuple):
    """A parameter that gets its value from elsewhere."""

    name: str
    where: Span


def named_values(robot: Robot) -> Iterator[Named]:
    if robot.of_kind("params"):
        yield from _of_params(robot)
    for file in robot.launch.judged if robot.of_kind(*LAUNCH) else ():
        for action in _walk(file.actions):
            for name, value in _pairs(action):
                text = _text(value)
                if text is not None:
                    yield Named(name, text, "launch")


def launch_words(robot: Robot) -> Iterator[tuple[Located, ...]]:
    """The arguments of every node and process, as far as they are literal."""
    if not robot.of_kind(*LAUNCH):
        return
    from bringup_lint.model.launch import Node
    from bringup_lint.model.launch import Process

    for file in robot.launch.judged:
        for action in _walk(file.actions):
            if isinstance(action, Process):
                values = action.arguments if isinstance(action, Node) else action.cmd
                yield tuple(text for value in values if (text := _text(value)) is not None)


def indirect(robot: Robot) -> Iterator[Indirect]:
    """Parameters that are filled from the environment or from arguments."""
    if not robot.of_kind("params", *LAUNCH):
        return
    from bringup_lint.model.launch import ComposableNode
    from bringup_lint.model.launch import Node
    from bringup_lint.model.launch import SetParameter
    from bringup_lint.model.launch_values import Argument
    from bringup_lint.model.launch_values import Env
    from bringup_lint.model.launch_values import walk

    for _, parameter in robot.params.parameters if robot.of_kind("params") else ():
        if "$(env " in parameter.text or "$(var " in parameter.text or "$(optenv " in parameter.text:
            yield Indirect(str(parameter.key).rpartition(".")[2], parameter.span)
    for file in robot.launch.judged if robot.of_kind(*LAUNCH) else ():
        for action in _walk(file.actions):
            if isinstance(action, (Node, ComposableNode, SetParameter)):
                for name, value in _parameters(action):
                    if any(isinstance(inner, (Argument, Env)) for inner in walk(value)):
                        yield Indirect(name.rpartition(".")[2], value.span)


def _of_params(robot: Robot) -> Iterator[Named]:
    for _, parameter in robot.params.parameters:
        users = None
        for item in robot.params.items(parameter):
            if item.type in ("string", "integer") and item.text:
                if users is None:
                    users = {str(each.value.data) for each in _beside(parameter)}
                value = Located(item.text, _inner(item.span, item.text))
                yield Named(str(parameter.key).rpartition(".")[2], value, "params", item.text in users)


def _beside(parameter: Parameter) -> Iterator[Parameter]:
    """The user names in the same mapping."""
    space = parameter.name.rpartition(".")[0]
    for other in parameter.block.parameters:
        if other.name.rpartition(".")[0] == space and other.name.endswith(USERS):
            yield other


def _inner(span: Span, text: str) -> Span:
    """Without the quotes around it."""
    at = span.text.find(text)
    return span if at < 0 else Span(span.source, span.start + at, span.start + at + len(text))


def _walk(actions: tuple[Action, ...]) -> Iterator[Action]:
    from bringup_lint.model.launch import walk_actions

    return walk_actions(actions)


def _pairs(action: Action) -> Iterator[tuple[str, Value]]:
    """Everything an action gives a name: parameters, variables, defaults of arguments."""
    from bringup_lint.graph.launch.resolve import text_of
    from bringup_lint.model.launch import DeclareArgument
    from bringup_lint.model.launch import Process
    from bringup_lint.model.launch import SetEnv

    yield from _parameters(action)
    if isinstance(action, Process):
        for name, value in (*action.additional_env, *(action.env or ())):
            yield text_of(name) or "", value
    elif isinstance(action, SetEnv):
        yield text_of(action.name) or "", action.value
    elif isinstance(action, DeclareArgument) and action.default is not None:
        yield text_of(action.name) or "", action.default


def _parameters(action: Action) -> Iterator[tuple[str, Value]]:
    from bringup_lint.graph.launch.resolve import text_of
    from bringup_lint.model.launch import ComposableNode
    from bringup_lint.model.launch import Node
    from bringup_lint.model.launch import SetParameter
    from bringup_lint.model.launch_values import DictValue

    if isinstance(action, SetParameter):
        yield text_of(action.name) or "", action.value
    elif isinstance(action, (Node, ComposableNode)):
        todo = [value for value in action.parameters if isinstance(value, DictValue)]
        while todo:
            for name, value in todo.pop().items:
                if isinstance(value, DictValue):
                    todo.append(value)
                else:
                    yield (text_of(name) or "").rpartition(".")[2], value


def _text(value: Value) -> Located | None:
    from bringup_lint.model.launch_values import TypedValue
    from bringup_lint.model.launch_values import literal

    return literal(value.value if isinstance(value, TypedValue) else value)
