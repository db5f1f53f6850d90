"""A node, component or process as it really starts."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.launch.resolve import Resolver
from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.graph.launch.scope import EnvChange
from bringup_lint.graph.launch.scope import EnvChanges
from bringup_lint.graph.launch.scope import Scope
from bringup_lint.model.launch import Action
from bringup_lint.model.launch import ComposableNode
from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Node
from bringup_lint.model.launch import Process
from bringup_lint.model.launch_values import Choice
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import Env
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Operation
from bringup_lint.model.launch_values import Value
from bringup_lint.model.launch_values import same
from bringup_lint.parsers.shell import split
from bringup_lint.source import Located
from bringup_lint.source import Span


@dataclass(eq=False, slots=True)
class Started:
    """One node, component or process of an expansion, with its values as far as they are known there."""

    action: Node | ComposableNode | Process
    file: LaunchFile
    """Where it is written."""
    package: Value | None = None
    executable: Value | None = None
    plugin: Value | None = None
    name: Value | None = None
    """None when the node keeps the name that its code gives it."""
    namespace: str | None = None
    """Absolute; None when it is not known."""
    usual_namespace: str | None = None
    """The one that it has when environment variables are not set; None when that is not known either."""
    parameters: tuple[Value, ...] = ()
    """In order, later ones win; those set for all nodes come first."""
    remappings: tuple[tuple[Value, Value], ...] = ()
    arguments: tuple[Value, ...] = ()
    env: dict[str, EnvChanges] = field(default_factory=dict)
    """How launch changes the environment: name -> changes in order."""
    own_env: bool = False
    """The environment holds these variables and nothing else (``env=``)."""
    options: dict[str, Value] = field(default_factory=dict)
    conditions: tuple[Condition, ...] = ()
    """Open ones, in terms of what the user may pass."""
    by_default: bool | None = True
    """Whether it starts when no argument is passed."""
    chain: tuple[Span, ...] = ()
    """The includes that lead here, outermost first."""
    context: tuple[Action, ...] = ()
    """The timers and handlers that it waits for."""
    container: Started | None = None

    @property
    def span(self) -> Span:
        return self.action.span

    @property
    def is_node(self) -> bool:
        return isinstance(self.action, (Node, ComposableNode)) or self.package is not None

    @property
    def given(self) -> Iterator[tuple[Value, Value]]:
        """The parameters that the launch file itself gives, by name."""
        for source in self.parameters:
            if isinstance(source, DictValue):
                yield from source.items

    @property
    def program(self) -> Located | None:
        """The class of a component, or the executable; None when that is not known."""
        return literal_text(self.plugin) or literal_text(self.executable)

    @property
    def fqn(self) -> str | None:
        """The fully qualified name; None when the name or namespace is not known, or not given."""
        name = literal_text(self.name)
        if name is None or self.namespace is None:
            return None
        return f"{self.namespace.rstrip('/')}/{name}"

    def label(self) -> str:
        """What to call it in a message."""
        for value in (self.name, self.plugin, self.executable, self.package):
            text = literal_text(value)
            if text:
                return text
        program = literal_text(self.arguments[0]) if self.arguments else None
        words = split(program) if program else []
        return words[0].rpartition("/")[2] if words else "the process"


def literal_text(value: Value | None) -> Located | None:
    """The text of a literal value, with its place."""
    if not isinstance(value, Literal):
        return None
    written = value.value
    if isinstance(written, Located):
        return written
    return value.text if isinstance(written, str) else None


def started(
    action: Node | ComposableNode | Process,
    file: LaunchFile,
    scope: Scope,
    resolver: Resolver,
    conditions: tuple[Condition, ...],
    chain: tuple[Span, ...],
    context: tuple[Action, ...],
    container: Started | None,
) -> Started:
    """The action with everything resolved that the context knows."""
    result = Started(action, file, conditions=conditions, chain=chain, context=context, container=container)
    result.name = resolver.optional(action.name)
    if isinstance(action, Process):
        result.options = {name: resolver.value(value) for name, value in action.options.items()}
        _environment(result, action, scope, resolver)
    if isinstance(action, (Node, ComposableNode)):
        result.package = resolver.optional(action.package)
        own = resolver.optional(action.namespace)
        result.namespace = namespace(scope.namespaces, own)
        result.usual_namespace = result.namespace or namespace(
            tuple(map(_usual, scope.namespaces)), own and _usual(own)
        )
        result.parameters = (*scope.parameters, *present(resolver.values(action.parameters)))
        result.remappings = (*scope.remaps, *resolver.pairs(action.remappings))
    if isinstance(action, Node):
        result.executable = resolver.optional(action.executable)
        result.arguments = resolver.values((*action.arguments, *action.ros_arguments))
    elif isinstance(action, ComposableNode):
        result.plugin = resolver.optional(action.plugin)
    else:
        _run_command(result, resolver.values(action.cmd))
    return result


def _environment(result: Started, action: Process, scope: Scope, resolver: Resolver) -> None:
    result.own_env = action.env is not None
    own = Scope(env={} if result.own_env else dict(scope.env))
    for origin, pairs in (("env", action.env or ()), ("additional_env", action.additional_env)):
        for name, value in resolver.pairs(pairs):
            text = text_of(name)
            if text is not None:
                own.change(text, EnvChange(value, origin, value.span))
    result.env = own.env


def present(values: tuple[Value, ...]) -> tuple[Value, ...]:
    """Without the choices of which none applies."""
    return tuple(value for value in values if not (isinstance(value, Choice) and not value.options))


def _run_command(result: Started, words: tuple[Value, ...]) -> None:
    """``ros2 run package executable`` starts a node like any other."""
    result.arguments = words
    result.name = None
    if len(words) >= 4 and text_of(words[0]) == "ros2" and text_of(words[1]) == "run":
        result.package, result.executable, result.arguments = words[2], words[3], words[4:]


def namespace(pushed: tuple[Value, ...], own: Value | None) -> str | None:
    """The absolute namespace as launch_ros joins it; None when part of it is not known."""
    result = ""
    for value in (*pushed, own):
        if value is None:
            continue
        text = text_of(value)
        if text is None:
            return None
        if text.startswith("/") or not result:
            result = text
        else:
            result = f"{result.rstrip('/')}/{text}" if text else result
        if result != "/":
            result = result.rstrip("/")
    return result if result.startswith("/") else f"/{result}"


def _usual(value: Value) -> Value:
    """What a value is when the environment does not hold the variable that it is made of."""
    if isinstance(value, Env) and value.default is not None and text_of(value.default):
        return value.default
    return value


def exclusive(first: Started, second: Started) -> bool:
    """Whether the conditions of two nodes rule out that both start."""
    return any(_contradict(ours, theirs) for ours in first.conditions for theirs in second.conditions)


def _contradict(ours: Condition, theirs: Condition) -> bool:
    if ours.kind == "loop" or theirs.kind == "loop":
        return False
    if same(ours.predicate, theirs.predicate):
        return ours.wanted is not theirs.wanted
    ours_value, theirs_value = _compared(ours), _compared(theirs)
    if ours_value is None or theirs_value is None:
        return False
    return same(ours_value[0], theirs_value[0]) and ours_value[1] != theirs_value[1]


def _compared(condition: Condition) -> tuple[Value, str] | None:
    """A value and the literal that it must equal."""
    predicate = condition.predicate
    if isinstance(predicate, Operation) and predicate.name in ("==", "equals") and condition.wanted:
        left, right = predicate.operands
        if isinstance(right, Literal):
            return left, str(right.value)
        if isinstance(left, Literal):
            return right, str(left.value)
    return None
