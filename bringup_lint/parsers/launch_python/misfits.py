"""Calls of launch's classes that their constructors, or launch when it visits the action, refuse with an exception."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Any

from bringup_lint.facts.ros.launch_calls import Signature
from bringup_lint.facts.ros.launch_calls import needs
from bringup_lint.facts.ros.launch_calls import signature
from bringup_lint.model.launch import RefusedCall
from bringup_lint.parsers.launch_python.arguments import Arguments
from bringup_lint.parsers.launch_python.objects import Bound
from bringup_lint.parsers.launch_python.objects import Description
from bringup_lint.parsers.launch_python.objects import Symbol
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.value_checks import CHECKS
from bringup_lint.parsers.launch_python.value_checks import kind_of
from bringup_lint.parsers.launch_python.value_checks import not_action
from bringup_lint.source import Span

_OLD = ("node_executable", "node_name", "node_namespace", "node_plugin")
"""Keywords of Foxy, which another rule judges by the distribution."""


def note_misfit(state: State, function: Any, call: ast.Call, args: Arguments) -> None:
    """Keep what a call gives that its class does not take, once however often the code runs."""
    if type(function) is Bound:
        _note_added(state, function, args)
    known = signature(function.name) if type(function) is Symbol else None
    if known is None:
        return
    owner = known.lineage[0]
    for code, word, where in _misnamed(state, known, call, args):
        _note(state, RefusedCall(code, owner, word, where))
    for word, (code, thing) in _mistyped(known, args):
        inside = thing is not None and args.span.start <= thing.span.start < args.span.end
        where = thing.span if inside else _place(state, known, call, word) or args.span
        given = kind_of(thing)
        _note(state, RefusedCall(code, owner, word, where, given))


def _note(state: State, refused: RefusedCall) -> None:
    if refused.where.start not in state.refused:
        state.refused.add(refused.where.start)
        state.file.calls_refused.append(refused)


def _note_added(state: State, function: Bound, args: Arguments) -> None:
    """``add_action`` takes one action."""
    if function.name == "add_action" and isinstance(function.owner, Description) and len(args.positional) == 1:
        for code, thing in not_action(args.positional[0]):
            _note(state, RefusedCall(code, "LaunchDescription", "add_action", thing.span, kind_of(thing)))


def _place(state: State, known: Signature, call: ast.Call, word: str) -> Span | None:
    """The value of a parameter in the call itself."""
    for keyword in call.keywords:
        if keyword.arg == word:
            return state.positions.span(keyword.value)
    at = known.positional.index(word) if word in known.positional else len(call.args)
    given = call.args[: at + 1]
    if len(given) <= at or any(isinstance(each, ast.Starred) for each in given):
        return None
    return state.positions.span(given[at])


def _misnamed(state: State, known: Signature, call: ast.Call, args: Arguments) -> Iterator[tuple[str, str, Span]]:
    """What is wrong, the parameter, and its place."""
    for keyword in call.keywords:
        if keyword.arg is not None and keyword.arg not in known.keywords:
            start = state.positions.span(keyword).start
            yield "keyword", keyword.arg, Span(state.file.source, start, start + len(keyword.arg))
            return
    if len(args.positional) > len(known.positional):
        if not any(isinstance(each, ast.Starred) for each in call.args):
            yield "positional", "", state.positions.span(call.args[len(known.positional)])
        return
    if args.more or any(word in args.keywords for word in _OLD):
        return
    given = {*known.positional[: len(args.positional)], *args.keywords}
    missing = [word for word in known.required if word not in given]
    if missing:
        yield "missing", ",".join(missing), state.positions.span(call.func)


def _mistyped(known: Signature, args: Arguments) -> Iterator[tuple[str, tuple[str, Any]]]:
    for word, what in needs(known).items():
        index = known.positional.index(word) if word in known.positional else None
        thing = args.get(word, index)
        if thing is not None:
            yield from ((word, found) for found in CHECKS[what](thing))
