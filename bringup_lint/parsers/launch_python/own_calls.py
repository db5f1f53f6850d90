"""Calls of the own functions of a launch file whose arguments do not fit."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator

from bringup_lint.model.launch import RefusedCall
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import called_name
from bringup_lint.model.python import dotted_name
from bringup_lint.model.python import walk
from bringup_lint.model.python_calls import misfit
from bringup_lint.parsers.launch_python.unbound import caught_in
from bringup_lint.parsers.python_syntax import Positions

_ENTRIES = ("generate_launch_description", "generate_test_description")
_CATCHING = frozenset({"TypeError", "Exception", "BaseException"})
_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


def own_misfits(tree: ast.Module, positions: Positions) -> Iterator[RefusedCall]:
    """In code that runs while launch does: of the module, of its entry, and of the functions that these name."""
    nodes = list(walk(tree))
    known = _known(tree, Counter(name for node in nodes for name in bound_names(node)))
    caught = caught_in(nodes, _CATCHING)
    for call in _calls(tree):
        for function, name, made in _made(call, known):
            wrong = misfit(made, function.args, False) if id(call) not in caught else None
            if wrong is not None:
                yield RefusedCall("own", name, wrong, positions.span(call.func))


def _known(tree: ast.Module, bound: Counter[str]) -> dict[str, FunctionNode]:
    """The functions, and as ``Class.name`` the static methods, that have one meaning each."""
    single = [each for each in tree.body if bound[getattr(each, "name", "")] == 1]
    found: dict[str, FunctionNode] = {each.name: each for each in single if isinstance(each, _FUNCTIONS)}
    found = {name: each for name, each in found.items() if not each.decorator_list}
    for owner in single:
        if not isinstance(owner, ast.ClassDef) or owner.decorator_list:
            continue
        methods = [each for each in owner.body if isinstance(each, _FUNCTIONS)]
        count = Counter(each.name for each in methods)
        for each in methods:
            if count[each.name] == 1 and [dotted_name(word) for word in each.decorator_list] == ["staticmethod"]:
                found[f"{owner.name}.{each.name}"] = each
    return found


def _calls(tree: ast.Module) -> Iterator[ast.Call]:
    functions = {each.name: each for each in tree.body if isinstance(each, _FUNCTIONS)}
    todo: list[ast.AST] = [each for each in tree.body if not isinstance(each, (*_FUNCTIONS, ast.ClassDef))]
    todo += [functions.pop(name) for name in _ENTRIES if name in functions]
    while todo:
        for node in walk(todo.pop(0)):
            if isinstance(node, ast.Call):
                yield node
            elif isinstance(node, ast.Name) and node.id in functions:
                todo.append(functions.pop(node.id))


def _made(call: ast.Call, known: dict[str, FunctionNode]) -> Iterator[tuple[FunctionNode, str, ast.Call]]:
    """The function that a call runs, its name, and the call as the function gets it."""
    name = dotted_name(call.func)
    if name in known:
        yield known[name], name, call
    elif called_name(call) == "OpaqueFunction":
        yield from _opaque(call, known)


def _opaque(call: ast.Call, known: dict[str, FunctionNode]) -> Iterator[tuple[FunctionNode, str, ast.Call]]:
    """launch hands the context over, then what ``args=`` and ``kwargs=`` hold."""
    given = {str(word.arg): word.value for word in call.keywords}
    function, args, kwargs = (
        given.get("function"),
        given.get("args", ast.List([])),
        given.get("kwargs", ast.Dict([], [])),
    )
    if not isinstance(function, ast.Name) or function.id not in known or not isinstance(args, (ast.List, ast.Tuple)):
        return
    words = _words(kwargs)
    if words is not None:
        made = ast.Call(call.func, [ast.Name("context", ast.Load()), *args.elts], words)
        yield known[function.id], function.id, made


def _words(kwargs: ast.expr) -> list[ast.keyword] | None:
    if not isinstance(kwargs, ast.Dict):
        return None
    names = [key.value for key in kwargs.keys if isinstance(key, ast.Constant) and isinstance(key.value, str)]
    words = [ast.keyword(name, value) for name, value in zip(names, kwargs.values)]
    return words if len(words) == len(kwargs.keys) else None
