"""Text of messages, requests and goals that becomes part of a shell command or of a program."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.memo import memo
from bringup_lint.graph.nodes.sources.callback_code import code_of
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.node_source import Callback
from bringup_lint.model.python import is_own
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeClass

DEPTH = 4
_SHELLS = ("os.system", "os.popen", "subprocess.getoutput", "subprocess.getstatusoutput")
_RUNNERS = ("subprocess.run", "subprocess.call", "subprocess.check_call", "subprocess.check_output", "subprocess.Popen")
_PROGRAMS = ("exec", "eval")
_PARTS = {"subscription": ".msg", "service": ".srv", "action": ".action"}
_SERVERS = {"action": "action-server"}
"""Role of a callback -> that of its endpoint, where it has another name."""
_CLEANS = ("strip", "lstrip", "rstrip", "lower", "upper", "split", "replace")
_KEEPS = ("put", "put_nowait", "append", "appendleft")
_GIVES = ("get", "get_nowait", "pop", "popleft")
_TEXT = regex(r"^[ \t]*(?:w?string)(?:<=\d+)?(?:\[[^\]]*\])?[ \t]+(?P<name>[a-z]\w*)[ \t]*(?:#.*|[\"'\w].*)?$")
_JOINS = (ast.JoinedStr, ast.FormattedValue, ast.BinOp, ast.List, ast.Tuple, ast.Starred)


class ShellCommand(NamedTuple):
    call: ast.Call
    """What hands the command to a shell."""
    callback: Callback
    what: str
    """``msg.data``."""

    @property
    def is_program(self) -> bool:
        """Whether Python itself runs the text: ``exec(msg.data)``."""
        return isinstance(self.call.func, ast.Name)


class _Flow(NamedTuple):
    syntax: Syntax
    node: NodeClass
    fields: frozenset[str]
    kept: set[str]
    """Attributes and queues of the node that hold text of a message: ``self.commands``."""


def shell_commands(nodes: Nodes, syntax: Syntax, node: NodeClass) -> Iterator[ShellCommand]:
    """The shell commands of a node that hold text from a subscription or a request, unquoted and unchecked."""
    if not any(name in syntax.named for name in (*_SHELLS, *_RUNNERS)) and not any(map(_runs_program, syntax.calls)):
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
        flow = _Flow(syntax, node, fields, set())
        call = next(_commands(flow, body, {message}, set(), DEPTH, set()), None) or next(_kept_commands(flow), None)
        if call is not None:
            whole = f"{message}.request" if callback.role == "action" else message
            yield ShellCommand(call, callback, f"{whole}.{sorted(fields)[0]}" if len(fields) == 1 else whole)


def _kept_commands(flow: _Flow) -> Iterator[ast.Call]:
    """The commands that other methods make of what a callback keeps for them."""
    seen: set[ast.AST] = set()
    mentions = flow.syntax.once(_Mentions)
    for method in flow.node.methods.values():
        if not flow.kept.isdisjoint(mentions.of(method.node)):
            yield from _commands(flow, body_of(method.node), set(), set(), DEPTH, seen)


class _Mentions:
    """The attributes of the node that methods name."""

    def __init__(self, _: Syntax) -> None:
        """It does not keep the syntax, which keeps it."""

    @memo
    def of(self, method: ast.AST) -> frozenset[str]:
        return frozenset(written(each) for each in walk(method) if is_own(each))


def _text_fields(nodes: Nodes, node: NodeClass, callback: Callback) -> frozenset[str]:
    """The fields of text in the messages of a callback; empty when the type is not known."""
    role = _SERVERS.get(callback.role, callback.role)
    types = {each.type for each in node.endpoints if each.callback == callback.name and each.role == role}
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
        if isinstance(each, ast.Assign):
            _assign(flow, each, messages, texts)
        elif isinstance(each, ast.For) and _is_text(flow, each.iter, messages, texts):
            texts |= {name.id for name in ast.walk(each.target) if isinstance(name, ast.Name)}
        if not isinstance(each, ast.Call):
            continue
        if _is_run(flow.syntax, each) and _is_text(flow, each.args[0], messages, texts):
            if not _is_known(flow, each, messages, texts):
                yield each
        elif _keeps(flow, each, messages, texts):
            flow.kept.add(written(each.func.value))  # type: ignore[attr-defined]
        elif depth:
            yield from _through(flow, each, messages, texts, depth, seen)


def _assign(flow: _Flow, each: ast.Assign, messages: set[str], texts: set[str]) -> None:
    names = {target.id for target in each.targets if isinstance(target, ast.Name)}
    if _is_message(each.value, messages):
        messages |= names
    elif _is_text(flow, each.value, messages, texts):
        texts |= names
        flow.kept.update(written(target) for target in each.targets if is_own(target))


def _is_message(value: ast.AST, messages: set[str]) -> bool:
    """``message``, or ``goal_handle.request``."""
    if isinstance(value, ast.Attribute) and value.attr == "request":
        value = value.value
    return isinstance(value, ast.Name) and value.id in messages


def _keeps(flow: _Flow, call: ast.Call, messages: set[str], texts: set[str]) -> bool:
    """``self.commands.put(text)``."""
    function = call.func
    if not isinstance(function, ast.Attribute) or function.attr not in _KEEPS or not is_own(function.value):
        return False
    return any(_is_text(flow, each, messages, texts) for each in call.args)


def _is_known(flow: _Flow, call: ast.Call, messages: set[str], texts: set[str]) -> bool:
    """Whether a condition around a call says which text it is."""
    tests = (outer.test for outer, name in flow.syntax.within(call) if isinstance(outer, ast.If) and name == "body")
    compared = (each for test in tests for each in ast.walk(test) if isinstance(each, ast.Compare))
    return any(_is_text(flow, part, messages, texts) for each in compared for part in (each.left, *each.comparators))


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
    """Whether a test compares the text with what is allowed; what is equal to one word may be anything else, too."""
    if all(isinstance(each, ast.Eq) for each in compare.ops):
        return False
    return any(_is_text(flow, each, messages, texts) for each in (compare.left, *compare.comparators))


def _is_text(flow: _Flow, value: ast.AST, messages: set[str], texts: set[str]) -> bool:
    """Whether an expression is text of a message, or holds it unquoted."""
    if isinstance(value, ast.Name):
        return value.id in texts
    if isinstance(value, ast.Attribute):
        is_field = _is_message(value.value, messages) and value.attr in flow.fields
        return is_field or (is_own(value) and written(value) in flow.kept)
    if isinstance(value, ast.Subscript):
        return _is_text(flow, value.value, messages, texts)
    if isinstance(value, _JOINS):
        return any(_is_text(flow, each, messages, texts) for each in ast.iter_child_nodes(value))
    if isinstance(value, ast.Call) and isinstance(value.func, ast.Attribute):
        if value.func.attr in (*_CLEANS, *_GIVES):
            return _is_text(flow, value.func.value, messages, texts)
        if value.func.attr in ("format", "join") and isinstance(value.func.value, ast.Constant):
            return any(_is_text(flow, each, messages, texts) for each in value.args)
    is_handed_on = isinstance(value, ast.Call) and len(value.args) == 1 and _hands_on(flow.syntax, value)
    return is_handed_on and _is_text(flow, value.args[0], messages, texts)  # type: ignore[attr-defined]


def _hands_on(syntax: Syntax, call: ast.Call) -> bool:
    """Whether the result of a call holds the text that it gets: ``str(text)``, ``json.loads(text)``."""
    return (isinstance(call.func, ast.Name) and call.func.id == "str") or syntax.qualified(call) == "json.loads"


def _runs_program(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Name) and call.func.id in _PROGRAMS and len(call.args) == 1


def _is_run(syntax: Syntax, call: ast.Call) -> bool:
    return _runs_program(call) or _hands_to_shell(syntax, call)


def _hands_to_shell(syntax: Syntax, call: ast.Call) -> bool:
    name = syntax.qualified(call)
    if not call.args:
        return False
    if name in _SHELLS:
        return True
    given = next((each.value for each in call.keywords if each.arg == "shell"), None)
    return name in _RUNNERS and isinstance(given, ast.Constant) and given.value is True
