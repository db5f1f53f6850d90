"""Calls: of the library, of methods, and of the file's own functions."""

from __future__ import annotations

import ast
from typing import Any

from bringup_lint.dataclass import replace
from bringup_lint.model.launch_values import Concat
from bringup_lint.model.launch_values import Literal
from bringup_lint.model.launch_values import PathJoin
from bringup_lint.model.launch_values import Unknown
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.containers import note_read_all
from bringup_lint.parsers.launch_python.library import LIBRARY
from bringup_lint.parsers.launch_python.library import key
from bringup_lint.parsers.launch_python.methods import method
from bringup_lint.parsers.launch_python.objects import Bound
from bringup_lint.parsers.launch_python.objects import Frame
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import Guards
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.state import relative
from bringup_lint.source import Span


def call(state: State, function: Any, positional: list[Any], keywords: dict[str, Any], more: bool, span: Span) -> Any:
    """Call whatever ``function`` stands for; ``more``: further arguments may be passed than are known."""
    arguments = Arguments(positional, keywords, more, span)
    if type(function) is Symbol:
        builder = LIBRARY.get(key(function.name))
        if builder is not None:
            return builder(state, arguments)
        why = f"call of {function.name}"
    elif type(function) is Bound:
        return method(state, function, arguments)
    elif type(function) is Function:
        return _invoke(state, function, arguments)
    else:
        why = function.why if isinstance(function, Unknown) else "call"
    opened(state, arguments)
    return Unknown(why, span)


def opened(state: State, arguments: Arguments) -> None:
    """Code that is not followed may add to the lists and dictionaries it gets."""
    for thing in (*arguments.positional, *arguments.keywords.values()):
        if isinstance(thing, (Sequence, Mapping)):
            thing.open = True
        else:
            note_read_all(state, thing)


def _invoke(state: State, function: Function, arguments: Arguments) -> Any:
    if state.calls >= budget.CALLS:
        return Unknown("calls nested too deeply", arguments.span)
    state.tick(20)
    frame = Frame(_bind(state, function, arguments), function.frame)
    outer, guards, jumps = state.frame, state.guards, state.jumps
    state.frame, state.jumps = frame, []
    state.calls += 1
    try:
        if isinstance(function.node, ast.Lambda):
            return _seen_from(state.evaluate(function.node.body), arguments.span)
        signal = state.run(function.node.body)
    finally:
        state.calls -= 1
        state.frame, state.guards, state.jumps = outer, guards, jumps
    return frame.yielded or _result(frame, guards, arguments.span, signal is None)


def _result(frame: Frame, guards: Guards, span: Span, goes_on: bool) -> Any:
    """What a function returns; also none where its end may be reached."""
    returns = [(relative(own, guards), value) for own, value in frame.returns]
    none = Literal(None, span)
    if goes_on and all(own for own, _ in returns):
        returns.insert(0, ((), none))
    if not returns:
        return none
    if len(returns) == 1 and not returns[0][0]:
        return none if returns[0][1] is None else _seen_from(returns[0][1], span)
    return Options([(own, none if value is None else value) for own, value in returns], span)


def _seen_from(value: Any, span: Span) -> Any:
    """A path that a function puts together is, for whoever reads the file, where the function is called."""
    return replace(value, span=span) if isinstance(value, (PathJoin, Concat)) else value


def _bind(state: State, function: Function, arguments: Arguments) -> dict[str, Any]:
    parameters = function.node.args
    names = [arg.arg for arg in (*parameters.posonlyargs, *parameters.args)]
    bound: dict[str, Any] = {}
    if function.defaults:
        bound.update(zip(names[-len(function.defaults) :], function.defaults))
    bound.update(function.keyword_defaults)
    bound.update(zip(names, arguments.positional))
    known = {*names, *(arg.arg for arg in parameters.kwonlyargs)}
    bound.update((name, value) for name, value in arguments.keywords.items() if name in known)
    if parameters.vararg is not None:
        rest: list[tuple[Guards, Any]] = [((), item) for item in arguments.positional[len(names) :]]
        bound[parameters.vararg.arg] = Sequence(rest, arguments.span, state.guards, arguments.more)
    if parameters.kwarg is not None:
        others = Mapping(arguments.span, open=arguments.more, base=state.guards)
        for name, value in arguments.keywords.items():
            if name not in known:
                others.entries[name] = (Literal(name, arguments.span), value)
        bound[parameters.kwarg.arg] = others
    for name in known - bound.keys():
        bound[name] = Unknown(f"parameter {name}", arguments.span)
    return bound
