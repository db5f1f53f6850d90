"""Pipes of child processes that nobody reads."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple

_STREAMS = ("stdout", "stderr")
_ENDLESS = (("run",), ("launch",))
"""Subcommands of ``ros2`` that run and write until they are stopped."""
_READS = frozenset({"communicate", *_STREAMS})
_ENDED = ("poll", "returncode")
"""What asks whether a process has ended: what is read then was never in its way."""


class UnreadPipe(NamedTuple):
    call: ast.Call
    streams: tuple[str, ...]
    """``stdout``, ``stderr``."""
    command: str
    """``ros2 launch``."""


def unread_pipes(syntax: Syntax) -> Iterator[UnreadPipe]:
    """The ROS programs whose output goes to a pipe that nothing in the file reads while they run."""
    for call in syntax.named.get("subprocess.Popen", []):
        given = {each.arg: each.value for each in call.keywords}
        streams = tuple(each for each in _STREAMS if each in given and _is_pipe(syntax, given[each]))
        command = _command(syntax, call) if streams else None
        if command is not None and not any(_may_read(syntax, call, node) for node in syntax.file.nodes):
            yield UnreadPipe(call, streams, command)


def _is_pipe(syntax: Syntax, value: ast.expr) -> bool:
    return syntax.file.qualified(value) == "subprocess.PIPE"


def _command(syntax: Syntax, call: ast.Call) -> str | None:
    """The ROS program that a call starts; None for all else."""
    given = call.args[0] if call.args else None
    if isinstance(given, ast.Name):
        given = _assigned(syntax, call, given.id)
    if isinstance(given, ast.Constant) and isinstance(given.value, str):
        words = given.value.split()[:3]
    elif isinstance(given, (ast.List, ast.Tuple)):
        words = [str(each.value) if isinstance(each, ast.Constant) else "" for each in given.elts[:3]]
    else:
        return None
    for subcommand in _ENDLESS:
        if words[0:1] == ["ros2"] and tuple(words[1 : 1 + len(subcommand)]) == subcommand:
            return " ".join(("ros2", *subcommand))
    return None


def _assigned(syntax: Syntax, call: ast.Call, name: str) -> ast.expr | None:
    """The one value that the function gives a variable."""
    function = syntax.function(call)
    if function is None:
        return None
    found = []
    for node in walk(function):
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        if isinstance(node, (ast.Assign, ast.AnnAssign)) and any(_is_name(each, name) for each in targets):
            found.append(node.value)
    return found[0] if len(found) == 1 else None


def _is_name(node: ast.AST | None, name: str) -> bool:
    return isinstance(node, ast.Name) and node.id == name


def _may_read(syntax: Syntax, started: ast.Call, node: ast.AST) -> bool:
    """Whether a node reads the output of some process that may be this one, or hands the process to other code."""
    if isinstance(node, ast.Attribute) and node.attr in _READS and isinstance(node.ctx, ast.Load):
        return not _is_other(syntax, started, node) and not _has_ended(syntax, node)
    return isinstance(node, ast.Call) and _is_handed(syntax, started, node)


def _is_other(syntax: Syntax, started: ast.Call, node: ast.Attribute) -> bool:
    """Whether what is read belongs to a process that another call of the same function starts, or to ``sys``."""
    if isinstance(node.value, ast.Name) and node.value.id in syntax.file.imports:
        return True
    function = syntax.function(node)
    if not isinstance(node.value, ast.Name) or function is None:
        return False
    made = _assigned_calls(function, node.value.id)
    return bool(made) and started not in made


def _assigned_calls(function: ast.AST, name: str) -> list[ast.expr]:
    assignments = (each for each in walk(function) if isinstance(each, ast.Assign))
    return [each.value for each in assignments if any(_is_name(target, name) for target in each.targets)]


def _has_ended(syntax: Syntax, node: ast.AST) -> bool:
    for outer, field in syntax.within(node):
        if isinstance(outer, ast.If) and field == "body":
            if any(isinstance(each, ast.Attribute) and each.attr in _ENDED for each in walk(outer.test)):
                return True
    return False


def _is_handed(syntax: Syntax, started: ast.Call, call: ast.Call) -> bool:
    """Whether a call gets the variable that keeps the process."""
    kept = next((each for each, _ in syntax.above(started)), None)
    target = kept.targets[0] if isinstance(kept, ast.Assign) else None
    if not isinstance(target, ast.Name) or syntax.function(call) is not syntax.function(started):
        return target is None
    words = [*call.args, *(each.value for each in call.keywords)]
    return any(_is_name(each, target.id) for word in words for each in ([word, *getattr(word, "elts", [])]))
