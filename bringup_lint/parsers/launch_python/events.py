"""Event handlers, events and the actions that carry them."""

from __future__ import annotations

from typing import Any

from bringup_lint.model.launch import Action
from bringup_lint.model.launch import Emit
from bringup_lint.model.launch import EventHandler
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.actions import conditions
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.nodes import handler_actions
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import Handler
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import Builder
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.source import Located

_CALLBACKS = ("on_exit", "on_start", "entities", "on_shutdown", "on_completion", "on_stdout", "on_stderr", "handler")
_TARGETS = ("target_action", "target_lifecycle_node", "action")


def _handler(name: str, callback: str | None = None) -> Builder:
    """``callback``: the keyword that the second positional argument stands for."""

    def builder(state: State, args: Arguments) -> Any:
        arguments = dict(args.keywords)
        positional = list(args.positional)
        if callback is not None and positional and "target_action" not in arguments and name != "OnShutdown":
            arguments["target_action"] = positional.pop(0)
        if callback is not None and positional:
            arguments[callback] = positional[0]
        target = next((arguments[word] for word in _TARGETS if isinstance(arguments.get(word), Action)), None)
        return Handler(name, target, arguments, args.span)

    return builder


def _register(state: State, args: Arguments) -> Any:
    handler = args.get("event_handler", 0)
    if not isinstance(handler, Handler):
        return EventHandler(span=args.span, conditions=conditions(args), event="")
    actions: tuple[Action, ...] = ()
    for word in _CALLBACKS:
        actions += handler_actions(state, handler.arguments.get(word), args)
    options = {
        name: freeze.value(state, thing)
        for name, thing in handler.arguments.items()
        if name in ("transition", "goal_state", "start_state")
    }
    return EventHandler(
        span=args.span,
        conditions=conditions(args),
        event=handler.name,
        target=handler.target.key if handler.target is not None else None,
        actions=actions,
        options=options,
    )


def _matches(state: State, args: Arguments) -> Any:
    target = args.get("action", 0)
    if isinstance(target, Action):
        return Handler("matches_action", target, {}, args.span)
    return Unknown("matcher", args.span)


def _matches_name(state: State, args: Arguments) -> Any:
    return Handler("matches_name", None, {"name": args.need("node_name", 0)}, args.span)


def _change_state(state: State, args: Arguments) -> Any:
    matcher = args.get("lifecycle_node_matcher")
    target = matcher.target if isinstance(matcher, Handler) else None
    if isinstance(matcher, Function):
        target = None
    arguments = {"transition_id": args.get("transition_id"), "matcher": matcher}
    return Handler("change-state", target, arguments, args.span)


def _event(name: str) -> Builder:
    def builder(state: State, args: Arguments) -> Any:
        return Handler(name, None, dict(args.keywords), args.span)

    return builder


def _transition(thing: Any, args: Arguments) -> Any:
    """A transition id by its number or as ``Transition.TRANSITION_CONFIGURE``."""
    if isinstance(thing, Literal):
        return thing
    if isinstance(thing, Symbol):
        return Literal(Located(thing.name.rpartition(".")[2], thing.span), thing.span)
    return Unknown("transition", args.span)


def _emit(state: State, args: Arguments) -> Any:
    event = args.get("event", 0)
    if not isinstance(event, Handler):
        return Emit(span=args.span, conditions=conditions(args), event="")
    names: tuple[Any, ...] = ()
    transition = None
    if event.name == "change-state":
        transition = _transition(event.arguments.get("transition_id"), args)
        matcher = event.arguments.get("matcher")
        if isinstance(matcher, Handler) and "name" in matcher.arguments:
            names = (freeze.text(state, matcher.arguments["name"]),)
        elif event.target is None:
            names = (Unknown("matcher", args.span),)
    target = None if event.target is None else event.target.key
    return Emit(
        span=args.span, conditions=conditions(args), event=event.name, target=target, names=names, transition=transition
    )


def _lifecycle_transition(state: State, args: Arguments) -> Any:
    names = freeze.values(state, args.get("lifecycle_node_names"))
    return Emit(span=args.span, conditions=conditions(args), event="change-state", names=names)


def _shutdown(state: State, args: Arguments) -> Any:
    return Emit(span=args.span, conditions=conditions(args), event="shutdown")


EVENTS = {
    "launch.RegisterEventHandler": _register,
    "launch.UnregisterEventHandler": _register,
    "launch.OnProcessExit": _handler("OnProcessExit", "on_exit"),
    "launch.OnProcessStart": _handler("OnProcessStart", "on_start"),
    "launch.OnExecutionComplete": _handler("OnExecutionComplete", "on_completion"),
    "launch.OnProcessIO": _handler("OnProcessIO"),
    "launch.OnShutdown": _handler("OnShutdown", "on_shutdown"),
    "launch.OnStateTransition": _handler("OnStateTransition"),
    "launch.OnIncludeLaunchDescription": _handler("OnIncludeLaunchDescription"),
    "launch.EventHandler": _handler("EventHandler"),
    "launch.EmitEvent": _emit,
    "launch.Shutdown": _shutdown,
    "launch.LifecycleTransition": _lifecycle_transition,
    "launch.matches_action": _matches,
    "launch.events.matches_action": _matches,
    "launch.events.matches_node_name": _matches_name,
    "launch.matches_node_name": _matches_name,
    "launch.events.ChangeState": _change_state,
    "launch.events.Shutdown": _event("shutdown"),
    "launch.events.SignalProcess": _event("SignalProcess"),
    "launch.events.ShutdownProcess": _event("ShutdownProcess"),
}
