"""Python launch files, read by a static evaluator over the syntax tree; nothing of them is ever executed."""

from __future__ import annotations

import ast
from typing import Any

from bringup_lint.model.launch import LaunchFile
from bringup_lint.model.launch import Other
from bringup_lint.parsers.launch_python import budget
from bringup_lint.parsers.launch_python import freeze
from bringup_lint.parsers.launch_python.calls import call
from bringup_lint.parsers.launch_python.expressions import condition
from bringup_lint.parsers.launch_python.expressions import evaluate
from bringup_lint.parsers.launch_python.idle_values import idle_values
from bringup_lint.parsers.launch_python.objects import Frame
from bringup_lint.parsers.launch_python.objects import Function
from bringup_lint.parsers.launch_python.objects import Mapping
from bringup_lint.parsers.launch_python.objects import Options
from bringup_lint.parsers.launch_python.objects import Sequence
from bringup_lint.parsers.launch_python.own_calls import own_misfits
from bringup_lint.parsers.launch_python.state import Evaluator
from bringup_lint.parsers.launch_python.state import State
from bringup_lint.parsers.launch_python.statements import run
from bringup_lint.parsers.launch_python.unbound import unbound
from bringup_lint.parsers.launch_python.unplaced import unplaced
from bringup_lint.parsers.launch_python.waits import MENTIONED
from bringup_lint.parsers.launch_python.waits import waits
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import note_imports
from bringup_lint.parsers.python_syntax import syntax_tree
from bringup_lint.pattern import regex
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

_COMMAND_LINE = regex(r"\bsys\b[^\n]*\bargv\b", hints="argv")
ENTRIES = ("generate_launch_description", "generate_test_description")


def parse(source: Source) -> LaunchFile:
    """The launch file's actions in order; ``problems`` hold what is not Python."""
    file = LaunchFile(source, "python")
    if len(source.text) > budget.TEXT:
        file.problems.append(Problem("too-large", source.whole))
        return file
    tree, problems = syntax_tree(source)
    file.problems += problems
    if tree is None:
        return file
    note_imports(source, tree)
    file.reads_all = _COMMAND_LINE.search(source.text) is not None
    positions = Positions(source, byte_order_mark(source))
    if MENTIONED.search(source.text):
        file.waits += waits(tree, positions)
    module = Frame({})
    state = State(file, positions, module, Evaluator(evaluate, condition, call, run))
    try:
        _describe(state, tree)
    except budget.Exhausted:
        file.actions += (Other(span=source.whole, why="the file is too long to follow"),)
    except RecursionError:
        file.actions += (Other(span=source.whole, why="nested too deeply"),)
    else:
        file.unbound += unbound(state, tree)
        file.calls_refused += own_misfits(tree, positions)
        file.unplaced += unplaced(tree, positions, source.text)
        file.idle += idle_values(tree, positions)
    finally:
        module.names.clear()  # its functions know it: without this, the syntax tree would wait for a search for garbage
    return file


def _describe(state: State, tree: ast.Module) -> None:
    run(state, tree.body)
    for name in ENTRIES:
        function = _function(state.frame.names.get(name))
        if isinstance(function, Function):
            state.file.entry = _name_span(state, function)
            break
        if function is not None:
            state.file.entry = state.file.source.whole
            state.file.actions = (Other(span=state.file.entry, why="entry function from elsewhere"),)
            return
    else:
        return
    state.guards = ()
    result = call(state, function, [], {}, False, state.file.entry)
    if isinstance(result, Sequence) and name == ENTRIES[1] and not hasattr(result, "add_action"):
        result = _without_context(result)
    state.file.actions = (*state.effects, *freeze.actions(state, result))


def _function(thing: Any) -> Any:
    """The entry function, also when the file defines it under a condition."""
    if isinstance(thing, Options):
        return next((option for _, option in thing.options if isinstance(option, Function)), thing)
    return thing


def _without_context(result: Sequence) -> Any:
    """A test description may come with a dictionary for the tests."""
    items = result.plain()
    return items[0] if items and len(items) == 2 and isinstance(items[1], Mapping) else result


def _name_span(state: State, function: Function) -> Span:
    span = state.positions.span(function.node)
    at = state.file.source.text.find(function.name, span.start, span.end)
    return Span(span.source, at, at + len(function.name)) if at >= 0 else span
