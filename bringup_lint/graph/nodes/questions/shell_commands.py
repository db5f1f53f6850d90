"""Text of messages and requests that becomes part of a shell command."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.callback_code import code_of
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import Callback
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeClass

DEPTH = 4
_SHELLS = ("os.system", "os.popen", "subprocess.getoutput", "subprocess.getstatusoutput")
_RUNNERS = ("subprocess.run", "subprocess.call", "subprocess.check_call", "subprocess.check_output", "subprocess.Popen")
_PARTS = {"subscription": ".msg", "service": ".srv"}
_TEXT = regex(r"^[ \t]*(?:w?string)(?:<=\d+)?(?:\[[^\]]*\])?[ \t]+(?P<name>[a-z]\w*)[ \t]*(?:#.*|[\"'\w].*)?$")
_JOINS = (ast.JoinedStr, ast.FormattedValue, ast.BinOp, ast.List, ast.Tuple, ast.Starred)


class ShellCommand(NamedTuple):
    call: ast.Call
    """What hands the command to a shell."""
    callback: Callback
    what: str
    """``msg.data``."""


class _Flow(NamedTuple):
    syntax: Syntax
    node: NodeClass
    fields: frozenset[str]


def shell_commands(nodes: Nodes, syntax: Syntax, node: NodeClass) -> Iterator[ShellCommand]:
    """The shell commands of a node that hold text from a subscription or a request, unquoted and unchecked."""
    if not any(name in syntax.named for name in (*_SHELLS, *_RUNNERS)):
        return
    for callback in node.callbacks:
        method = node.methods.get(callback.name or "")
        if callback.role not in _PARTS or method is None or len(method.node.args.args) < 2:
            continue
        fields = _text_fields(nodes, node, callback)
        name, body = code_of(nodes.ending(nodes.file_of(node)), node, callback)
        if not fields or not name:
            continue
        message = method.node.args.args[1].arg
        flow = _Flow(syntax, node, fields)
        for call in _commands(flow, body, {message}, set(), DEPTH, set()):
            yield ShellCommand(call, callback, f"{message}.{sorted(fields)[0]}" if len(fields) == 1 else message)
            break


def _text_fields(nodes: Nodes, node: NodeClass, callback: Callback) -> frozenset[str]:
    """The fields of text in the messages of a callback; empty when the type is not known."""
    types = {each.type for each in node.endpoints if each.callback == callback.name and each.role == callback.role}
    kind = next(iter(types)) if len(types) == 1 else None
    if kind is None:
        return frozenset()
    if kind == "std_msgs/msg/String":
        return frozenset({"data"})
    name = kind.rpartition("/")[2] + _PARTS[callback.role]
    found = list(nodes.files.tree.named(name))
    source = nodes.files.tree.read(found[0], judged=False) if len(found) == 1 else None
    if source is None:
        return frozenset()
    lines = source.text.split("\n---")[0].splitlines()
    return frozenset(match["name"] for line in lines if (match := _TEXT.match(line)) and "=" not in line)


def _commands(
    flow: _Flow, body: list[ast.AST], messages: set[str], texts: set[str], depth: int, seen: set[ast.AST]
) -> Iterator[ast.Call]:
    """``messages``: names of messages; ``texts``: names that hold text of one."""
    nodes = list(own(body))
    if any(isinstance(each, ast.Compare) and _checks(flow, each, messages, texts) for each in nodes):
        return
    for each in nodes:
        if isinstance(each, ast.Assign) and _is_text(flow, each.value, messages, texts):
            texts |= {target.id for target in each.targets if isinstance(target, ast.Name)}
        if not isinstance(each, ast.Call):
            continue
        if _hands_to_shell(flow.syntax, each) and _is_text(flow, each.args[0], messages, texts):
            yield each
        elif depth:
            yield from _through(flow, each, messages, texts, depth, seen)


def _through(
    flow: _Flow, call: ast.Call, messages: set[str], texts: set[str], depth: int, seen: set[ast.AST]
) -> Iterator[ast.Call]:
    for function, owner in called(flow.syntax, call, flow.node):
        names = [each.arg for each in function.args.args][1 if owner is not None else 0 :]
        pairs = [*zip(names, call.args), *((each.arg or "", each.value) for each in call.keywords)]
        whole = {name for name, value in pairs if isinstance(value, ast.Name) and value.id in messages}
        text = {name for name, value in pairs if _is_text(flow, value, messages, texts)}
        if (whole or text) and function not in seen:
            seen.add(function)
            yield from _commands(flow, body_of(function), whole, text, depth - 1, seen)


def _checks(flow: _Flow, compare: ast.Compare, messages: set[str], texts: set[str]) -> bool:
    """Whether a test compares the text with what is allowed."""
    return any(_is_text(flow, each, messages, texts) for each in (compare.left, *compare.comparators))


def _is_text(flow: _Flow, value: ast.AST, messages: set[str], texts: set[str]) -> bool:
    """Whether an expression is text of a message, or holds it unquoted."""
    if isinstance(value, ast.Name):
        return value.id in texts
    if isinstance(value, ast.Attribute):
        return isinstance(value.value, ast.Name) and value.value.id in messages and value.attr in flow.fields
    if isinstance(value, _JOINS):
        return any(_is_text(flow, each, messages, texts) for each in ast.iter_child_nodes(value))
    if isinstance(value, ast.Call) and isinstance(value.func, ast.Attribute):
        if value.func.attr in ("strip", "lower", "upper"):
            return _is_text(flow, value.func.value, messages, texts)
        if value.func.attr in ("format", "join") and isinstance(value.func.value, ast.Constant):
            return any(_is_text(flow, each, messages, texts) for each in value.args)
    return isinstance(value, ast.Call) and _is_str(value) and _is_text(flow, value.args[0], messages, texts)


def _is_str(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Name) and call.func.id == "str" and len(call.args) == 1


def _hands_to_shell(syntax: Syntax, call: ast.Call) -> bool:
    name = syntax.qualified(call)
    if not call.args:
        return False
    if name in _SHELLS:
        return True
    given = next((each.value for each in call.keywords if each.arg == "shell"), None)
    return name in _RUNNERS and isinstance(given, ast.Constant) and given.value is True
