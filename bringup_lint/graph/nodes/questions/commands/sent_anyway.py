"""What a loop sends whatever the age of the command that it keeps, although its file looks at times."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.nodes.sources.age import looks_at_age
from bringup_lint.graph.nodes.sources.callback_code import reached
from bringup_lint.graph.nodes.sources.kept_commands import Loop
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import called_name
from bringup_lint.model.python import is_own
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.pattern import regex

DEPTH = 4
"""Calls through which what a sender does is followed."""
_STOPS = regex(r"(?i)stop|halt|brake|disable|disarm|zero|neutral|reset|idle|abort|kill|release")
_ENDS = frozenset({"__init__", "destroy_node", "__del__", "__exit__"})
_TESTS = (ast.If, ast.IfExp, ast.While, ast.Assert)
_PLAIN = frozenset({"isinstance", "len", "abs", "bool", "float", "int", "math.isfinite", "math.isnan"})


def is_sent_anyway(
    syntax: Syntax, files: list[NodeSource], node: NodeClass, loop: Loop, kept: str, sender: ast.Call
) -> bool:
    """Whether the method of a loop always sends what a message left in an attribute: nothing that it does before
    depends on what changes otherwise, nor does what it calls, and no code stops what it sends to."""
    method = node.methods[loop.name]
    if syntax.function(sender) is not method.node or not _mentions(sender.args, kept):
        return False
    later = (each for name, each in node.methods.items() if name != "__init__")
    moving = {name for each in later for name in _set_in(each.node)} - {kept}
    return (
        not _decides(syntax, node, sender, moving)
        and not _is_reworked(node, kept, sender)
        and not _is_stopped(node, sender)
        and not _looks_at_age(files, sender)
    )


def _set_in(function: ast.AST) -> Iterator[str]:
    """The attributes of ``self`` that a method sets."""
    for each in walk(function):
        if is_own(each) and not isinstance(each.ctx, ast.Load):
            yield each.attr


def _mentions(values: Iterable[ast.AST], kept: str) -> bool:
    return any(is_own(each) and each.attr == kept for value in values for each in ast.walk(value))


def _decides(syntax: Syntax, node: NodeClass, sender: ast.Call, moving: set[str]) -> bool:
    """Whether a condition up to the call depends on what changes while the node runs, but the command itself."""
    if any(isinstance(outer, ast.ExceptHandler) for outer, _ in syntax.within(sender)):
        return True
    before = list(_until(body_of(syntax.function(sender)), sender))
    for each in (*before, *reached(syntax, before, node)):
        is_asked = isinstance(each, ast.expr) and (each in before or isinstance(each, (ast.Compare, ast.BoolOp)))
        test = each if is_asked else getattr(each, "test", None) if isinstance(each, _TESTS) else None
        if isinstance(each, ast.Match) or (isinstance(test, ast.expr) and not _is_steady(test, moving)):
            return True
    return False


def _until(body: Iterable[ast.AST], sender: ast.Call) -> Iterator[ast.AST]:
    """The simple statements up to a call, and the conditions of the others."""
    for each in own(body):
        if not isinstance(each, ast.stmt) or each.lineno > sender.lineno:
            continue
        if isinstance(each, (ast.If, ast.While)):
            yield each.test
        elif isinstance(each, (ast.For, ast.AsyncFor)):
            yield each.iter
        elif isinstance(each, ast.Match) or not hasattr(each, "body"):
            yield each


def _is_steady(test: ast.expr, moving: set[str]) -> bool:
    """Whether a condition asks for nothing but attributes that stay as they are, and numbers."""
    for each in ast.walk(test):
        if isinstance(each, ast.Call) and written(each.func) not in _PLAIN:
            return False
        if is_own(each) and each.attr in moving:
            return False
        if isinstance(each, ast.Name) and each.id not in (*_PLAIN, "self", "math") and not each.id.isupper():
            return False
    return True


def _is_reworked(node: NodeClass, kept: str, sender: ast.Call) -> bool:
    """Whether the command goes through, or is changed by, another call than the one that sends it."""
    for call in (each for each in node.inner if isinstance(each, ast.Call) and each is not sender):
        owner = call.func.value if isinstance(call.func, ast.Attribute) else None
        if owner is not None and _mentions([owner], kept):
            return True
        handed = [each for each in call.args if isinstance(each, ast.Attribute) and _mentions([each], kept)]
        if any(each.attr == kept for each in handed) or (_is_inside(call, sender) and _mentions(call.args, kept)):
            return True
    return False


def _is_inside(call: ast.Call, outer: ast.Call) -> bool:
    return any(each is call for each in ast.walk(outer))


def _is_stopped(node: NodeClass, sender: ast.Call) -> bool:
    """Whether code of the class may stop by another call what the loop sends to."""
    for name, method in node.methods.items():
        statements = own(body_of(method.node)) if name not in _ENDS else ()
        for call in (each.value for each in statements if isinstance(each, ast.Expr)):
            function = call.func if isinstance(call, ast.Call) and call is not sender else None
            if not isinstance(function, ast.Attribute) or is_self(function.value):
                continue
            if _STOPS.search(function.attr) or written(function) == written(sender.func):
                return True
    return False


def _looks_at_age(files: list[NodeSource], sender: ast.Call) -> bool:
    """Whether the functions of the workspace that the call may mean, and what they call, look at a time."""
    todo, seen = {str(getattr(sender.func, "attr", ""))}, set[str]()
    for _ in range(DEPTH):
        texts = list(_bodies(files, todo - seen))
        seen |= todo
        if any(looks_at_age(written(each)) for each in texts):
            return True
        todo = {called_name(call) for each in texts for call in own_calls(body_of(each))} - seen
    return False


def _bodies(files: list[NodeSource], names: set[str]) -> Iterator[ast.AST]:
    for file in files:
        for each in file.nodes:
            if isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef)) and each.name in names:
                yield each
