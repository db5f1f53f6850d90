"""Actions that the code of a launch file makes and hands to nothing."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.launch import UnplacedAction
from bringup_lint.model.python import children
from bringup_lint.parsers.launch_python.unbound import DYNAMIC
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_MODULES = ("launch.actions", "launch_ros.actions")
_WORD = regex(r"\w+")
_SCOPES = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


@dataclass(eq=False, slots=True)
class _Seen:
    classes: dict[str, str] = field(default_factory=dict)
    """The classes of actions by the names that the file has for them."""
    read: set[str] = field(default_factory=set)
    put_away: list[str] = field(default_factory=list)
    """Texts that stand alone."""


def unplaced(tree: ast.Module, positions: Positions, text: str) -> Iterator[UnplacedAction]:
    """Those whose variable nothing reads, and that no comment or text that stands alone mentions, and those that are
    made in a statement of their own."""
    seen = _Seen()
    made: list[tuple[ast.Name, ast.Call]] = []
    alone: list[ast.Call] = []
    todo: list[tuple[ast.AST, bool]] = [(tree, False)]
    while todo:
        node, is_local = todo.pop()
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
            continue
        _note(seen, node)
        made += _kept_call(node) if is_local else ()
        alone += _lone_call(node) if is_local else ()
        is_inner = isinstance(node, _SCOPES) or (is_local and not isinstance(node, ast.ClassDef))
        todo.extend((child, is_inner) for child in children(node))
    if seen.read & DYNAMIC:
        return
    used = seen.read | _mentioned(text, seen.put_away) if made else seen.read
    for name, call in sorted(made, key=lambda each: each[0].lineno):
        owner = _class_of(call.func, seen.classes)
        if owner and name.id not in used:
            yield UnplacedAction(Located(name.id, positions.span(name)), owner, _first_text(call), _executable(call))
    for call in alone:
        owner = _class_of(call.func, seen.classes)
        if owner:
            place = Located(owner, positions.span(call.func))
            yield UnplacedAction(place, owner, _first_text(call), _executable(call), is_kept=False)


def _note(seen: _Seen, node: ast.AST) -> None:
    if isinstance(node, ast.ImportFrom) and node.module in _MODULES:
        seen.classes.update((alias.asname or alias.name, alias.name) for alias in node.names)
    elif isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Store):
        seen.read.add(node.id)
    elif isinstance(node, (ast.Global, ast.Nonlocal)):
        seen.read.update(node.names)
    elif isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        seen.put_away.append(str(node.value.value))


def _kept_call(node: ast.AST) -> Iterator[tuple[ast.Name, ast.Call]]:
    """The variable that a statement gives the value of a call."""
    if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.value, ast.Call):
        target = node.targets[0]
        if isinstance(target, ast.Name):
            yield target, node.value


def _lone_call(node: ast.AST) -> Iterator[ast.Call]:
    """The call that is a statement of its own, with a comma behind it or without."""
    if isinstance(node, ast.Expr):
        parts = node.value.elts if isinstance(node.value, ast.Tuple) else [node.value]
        yield from (part for part in parts if isinstance(part, ast.Call))


def _class_of(function: ast.expr, classes: dict[str, str]) -> str:
    """The class of an action that is called, as its module calls it; empty for anything else."""
    if isinstance(function, ast.Name):
        return classes.get(function.id, "")
    module = function.value if isinstance(function, ast.Attribute) else None
    package = module.value if isinstance(module, ast.Attribute) else None
    if isinstance(module, ast.Attribute) and isinstance(package, ast.Name):
        return getattr(function, "attr", "") if f"{package.id}.{module.attr}" in _MODULES else ""
    return ""


def _first_text(call: ast.Call) -> str:
    """The name that a call gives what it makes."""
    named = [*call.args[:1], *(word.value for word in call.keywords if word.arg == "name")]
    texts = (each.value for each in named if isinstance(each, ast.Constant))
    return str(next(texts, ""))


def _executable(call: ast.Call) -> str:
    words = (each.value for each in call.keywords if each.arg == "executable")
    return next((str(each.value) for each in words if isinstance(each, ast.Constant)), "")


def _mentioned(text: str, put_away: list[str]) -> set[str]:
    """The words of comments, and of texts that stand alone."""
    comments = (line.partition("#")[2] for line in text.splitlines() if "#" in line)
    return {word for each in (*comments, *put_away) for word in _WORD.findall(each)}
