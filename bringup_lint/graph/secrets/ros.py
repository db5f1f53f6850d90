"""Secrets in parameter files and launch files: in clear text, or in a parameter that everybody may ask for."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.launch import Action
    from bringup_lint.model.launch_values import Value
    from bringup_lint.model.params import Block

SUBSTITUTIONS = ("$(env ", "$(var ", "$(optenv ")
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


def named_values(files: Files, launch: Callable[[], Launch], params: Callable[[], Params]) -> Iterator[Named]:
    """Every literal value of parameter files and launch files, with its name."""
    if files.of_kind("params"):
        yield from _of_params(params())
    for action in _actions(files, launch):
        for name, value in _pairs(action):
            text = _text(value)
            if text is not None:
                yield Named(name, text, "launch")


def _actions(files: Files, launch: Callable[[], Launch]) -> Iterator[Action]:
    """The actions of the judged launch files."""
    if not files.of_kind(*LAUNCH):
        return
    from bringup_lint.model.launch import walk_actions

    for file in launch().judged:
        yield from walk_actions(file.actions)


def launch_words(files: Files, launch: Callable[[], Launch]) -> Iterator[tuple[Located, ...]]:
    """The arguments of every node and process, as far as they are literal."""
    for action in _actions(files, launch):
        from bringup_lint.model.launch import Node
        from bringup_lint.model.launch import Process

        if isinstance(action, Process):
            values = action.arguments if isinstance(action, Node) else action.cmd
            yield tuple(text for value in values if (text := _text(value)) is not None)


def indirect(files: Files, launch: Callable[[], Launch], params: Callable[[], Params]) -> Iterator[Indirect]:
    """Parameters that are filled from the environment or from arguments."""
    if files.of_kind("params"):
        for _, parameter in params().parameters:
            if any(substitution in parameter.text for substitution in SUBSTITUTIONS):
                yield Indirect(str(parameter.key).rpartition(".")[2], parameter.span)
    for action in _actions(files, launch):
        for name, value in _parameters(action):
            if _is_filled(value) and _may_take(files, launch(), action, name):
                yield Indirect(name.rpartition(".")[2], value.span)


def _may_take(files: Files, launch: Launch, action: Action, name: str) -> bool:
    """Whether the package of a node may declare a parameter: another one is on no graph."""
    from bringup_lint.graph.launch.started import literal_text
    from bringup_lint.graph.params.declared import may_declare
    from bringup_lint.model.launch import Node

    if not isinstance(action, Node):
        return True
    package = launch.workspace.packages.get(literal_text(action.package) or "")
    executable = literal_text(action.executable) or ""
    return package is None or may_declare(files, launch.workspace, package, executable, name)


def _is_filled(value: Value) -> bool:
    """Whether a value depends on an argument or on the environment."""
    from bringup_lint.model.launch_values import Argument
    from bringup_lint.model.launch_values import Env
    from bringup_lint.model.launch_values import walk

    return any(isinstance(inner, (Argument, Env)) for inner in walk(value))


def _of_params(params: Params) -> Iterator[Named]:
    users: dict[Block, dict[str, set[str]]] = {}
    for _, parameter in params.parameters:
        block = parameter.block
        if block not in users:
            users[block] = _users(block)
        values = [item for item in params.items(parameter) if item.type in ("string", "integer") and item.text]
        beside = users[block].get(parameter.name.rpartition(".")[0], ())
        for item in values:
            value = Located(item.text, _inner(item.span, item.text))
            yield Named(str(parameter.key).rpartition(".")[2], value, "params", item.text in beside)


def _users(block: Block) -> dict[str, set[str]]:
    """The user names of a block, by the mapping that they are in."""
    found: dict[str, set[str]] = {}
    for parameter in block.parameters:
        if parameter.name.endswith(USERS):
            found.setdefault(parameter.name.rpartition(".")[0], set()).add(str(parameter.value.data))
    return found


def _inner(span: Span, text: str) -> Span:
    """Without the quotes around it."""
    at = span.text.find(text)
    return span if at < 0 else Span(span.source, span.start + at, span.start + at + len(text))


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
