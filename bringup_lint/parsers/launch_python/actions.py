"""Actions of launch."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from bringup_lint.model.launch import Action
from bringup_lint.model.launch import DeclareArgument
from bringup_lint.model.launch import Group
from bringup_lint.model.launch import Include
from bringup_lint.model.launch import Log
from bringup_lint.model.launch import Opaque
from bringup_lint.model.launch import Other
from bringup_lint.model.launch import PushNamespace
from bringup_lint.model.launch import Scope
from bringup_lint.model.launch import SetArgument
from bringup_lint.model.launch import SetEnv
from bringup_lint.model.launch import SetParameter
from bringup_lint.model.launch import SetParametersFromFile
from bringup_lint.model.launch import SetRemap
from bringup_lint.model.launch import Timer
from bringup_lint.model.launch import UnsetArgument
from bringup_lint.model.launch import UnsetEnv
from bringup_lint.model.launch_values import Condition
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.containers import extend
from bringup_lint.parsers.launch_python.objects import Context
from bringup_lint.parsers.launch_python.objects import Description
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import LaunchSource
from bringup_lint.parsers.launch_python.objects import Placed
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.state import Builder
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.substitutions import parameter
from bringup_lint.parsers.launch_python.unperformed import note_object


def conditions(args: Arguments) -> tuple[Condition, ...]:
    """The ``condition=`` of an action."""
    thing = args.get("condition")
    if thing is None or freeze.is_none(thing):
        return ()
    if isinstance(thing, Placed):
        return (thing.condition,)
    span = freeze.span_of(thing, args.span)
    return (Condition(Unknown("condition", span), True, "if", span),)


def _description(state: State, args: Arguments) -> Any:
    result = Description([], args.span, state.guards, open=args.more)
    initial = args.get("initial_entities", 0)
    if initial is not None and not freeze.is_none(initial):
        extend(state, result, initial, ())
    return result


def _declare(state: State, args: Arguments) -> Any:
    choices = args.get("choices")
    known = isinstance(choices, Sequence) and choices.plain() is not None
    return DeclareArgument(
        span=args.span,
        conditions=conditions(args),
        name=freeze.text(state, args.need("name", 0)),
        default=freeze.optional_text(state, args.get("default_value", 1)),
        description=freeze.optional_text(state, args.get("description", 2)),
        choices=freeze.values(state, choices) if known else None,
    )


def _include(state: State, args: Arguments) -> Any:
    source = args.need("launch_description_source", 0)
    if isinstance(source, LaunchSource):
        file = source.file
    elif isinstance(source, Description):
        return Group(
            span=args.span,
            conditions=conditions(args),
            actions=freeze.actions(state, source),
            scoped=Literal(False, args.span),
        )
    else:
        file = freeze.text(state, source)
    arguments = args.get("launch_arguments")
    pairs, more = freeze.pairs(state, arguments)
    for key, _ in pairs:
        note_object(state, "argument-name", key, freeze.span_of(arguments, args.span))
    return Include(span=args.span, conditions=conditions(args), file=file, arguments=pairs, open=more or args.more)


def _group(state: State, args: Arguments) -> Any:
    pairs, _ = freeze.pairs(state, args.get("launch_configurations"))
    return Group(
        span=args.span,
        conditions=conditions(args),
        actions=freeze.actions(state, args.need("actions", 0)),
        scoped=freeze.optional_text(state, args.get("scoped")),
        forwarding=freeze.optional_text(state, args.get("forwarding")),
        arguments=pairs,
    )


def _timer(state: State, args: Arguments) -> Any:
    return Timer(
        span=args.span,
        conditions=conditions(args),
        period=freeze.text(state, args.need("period")),
        actions=freeze.actions(state, args.need("actions")),
    )


def _opaque(state: State, args: Arguments) -> Any:
    function = args.need("function", 0)
    extra = args.get("args")
    named = args.get("kwargs")
    outer, before = state.guards, state.effects
    name = function.name if isinstance(function, Function) else "function"
    if not isinstance(function, Function):
        why = function.why if isinstance(function, Unknown) else "function"
        return Opaque(span=args.span, function=name, actions=(Other(span=args.span, why=why),))
    positional = [Context(args.span), *(extra.plain() or () if isinstance(extra, Sequence) else ())]
    keywords = {str(key): value for key, (_, value) in getattr(named, "entries", {}).items()}
    state.guards, state.effects = (), []
    state.deferred += 1
    try:
        result = state.call(function, positional, keywords, False, args.span)
        actions = (*state.effects, *freeze.actions(state, result))
    finally:
        state.deferred -= 1
        state.guards, state.effects = outer, before
    return Opaque(span=args.span, conditions=conditions(args), function=name, actions=actions)


def _for_each(state: State, args: Arguments) -> Any:
    """``ForEach``: the function makes actions for every entry of a text that only the run knows."""
    function = args.get("function", 1)
    if not isinstance(function, Function):
        return Other(span=args.span, conditions=conditions(args), why="function")
    loop = Condition(freeze.text(state, args.need("input_values", 0)), True, "loop", args.span)
    state.deferred += 1
    try:
        actions = freeze.actions(state, state.call(function, [], {}, False, args.span))
    finally:
        state.deferred -= 1
    return Opaque(span=args.span, conditions=(loop, *conditions(args)), function=function.name, actions=actions)


def _simple(kind: Callable[..., Action], **parameters: int | None) -> Builder:
    """An action whose parameters are texts; the number is the position."""

    def builder(state: State, args: Arguments) -> Any:
        values = {}
        for name, index in parameters.items():
            thing = args.need(name, index)
            values[name] = parameter(state, thing) if name == "value" else freeze.text(state, thing)
        return kind(span=args.span, conditions=conditions(args), **values)

    return builder


def _push_namespace(state: State, args: Arguments) -> Any:
    namespace = freeze.text(state, args.need("namespace", 0))
    return PushNamespace(span=args.span, conditions=conditions(args), namespace=namespace)


def _use_sim_time(state: State, args: Arguments) -> Any:
    value = freeze.text(state, args.need("value", 0))
    return SetParameter(
        span=args.span, conditions=conditions(args), name=Literal("use_sim_time", args.span), value=value
    )


def _append_env(state: State, args: Arguments) -> Any:
    prepend = args.get("prepend", 2)
    mode = "prepend" if isinstance(prepend, Literal) and prepend.value is True else "append"
    name, value = freeze.text(state, args.need("name", 0)), freeze.text(state, args.need("value", 1))
    separator = freeze.optional_text(state, args.get("separator", 3))
    return SetEnv(span=args.span, conditions=conditions(args), name=name, value=value, mode=mode, separator=separator)


def _scope(what: str, push: bool) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        return Scope(span=args.span, conditions=conditions(args), what=what, push=push)

    return builder


def _all_unset(kind: type[Action]) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        return kind(span=args.span, conditions=conditions(args))

    return builder


def _log(state: State, args: Arguments) -> Any:
    return Log(span=args.span, conditions=conditions(args), message=freeze.optional_text(state, args.get("msg", 0)))


def _nothing(state: State, args: Arguments) -> Any:
    return Log(span=args.span, conditions=conditions(args))


def _log_dir(state: State, args: Arguments) -> Any:
    value = freeze.text(state, args.need("new_log_dir", 0))
    return SetEnv(span=args.span, conditions=conditions(args), name=Literal("ROS_LOG_DIR", args.span), value=value)


ACTIONS = {
    "launch.LaunchDescription": _description,
    "launch.DeclareLaunchArgument": _declare,
    "launch.IncludeLaunchDescription": _include,
    "launch.GroupAction": _group,
    "launch.TimerAction": _timer,
    "launch.RosTimer": _timer,
    "launch.ROSTimer": _timer,
    "launch.OpaqueFunction": _opaque,
    "launch.ForEach": _for_each,
    "launch.OpaqueCoroutine": _nothing,
    "launch.SetLaunchConfiguration": _simple(SetArgument, name=0, value=1),
    "launch.UnsetLaunchConfiguration": _simple(UnsetArgument, name=0),
    "launch.ResetLaunchConfigurations": _all_unset(UnsetArgument),
    "launch.PushLaunchConfigurations": _scope("arguments", True),
    "launch.PopLaunchConfigurations": _scope("arguments", False),
    "launch.SetEnvironmentVariable": _simple(SetEnv, name=0, value=1),
    "launch.AppendEnvironmentVariable": _append_env,
    "launch.UnsetEnvironmentVariable": _simple(UnsetEnv, name=0),
    "launch.ResetEnvironment": _all_unset(UnsetEnv),
    "launch.PushEnvironment": _scope("environment", True),
    "launch.PopEnvironment": _scope("environment", False),
    "launch.SetRemap": _simple(SetRemap, src=0, dst=1),
    "launch.SetParameter": _simple(SetParameter, name=0, value=1),
    "launch.SetParametersFromFile": lambda state, args: SetParametersFromFile(
        span=args.span, conditions=conditions(args), file=freeze.text(state, args.need("filename", 0))
    ),
    "launch.SetUseSimTime": _use_sim_time,
    "launch.SetROSLogDir": _log_dir,
    "launch.PushRosNamespace": _push_namespace,
    "launch.PushROSNamespace": _push_namespace,
    "launch.LogInfo": _log,
    "launch.LogWarning": _log,
    "launch.LogError": _log,
    "launch.LogDebug": _log,
    "launch.ReadyToTest": _nothing,
    "launch.ReadyAction": _nothing,
}
