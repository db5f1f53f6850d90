"""Names of ROS that a node source uses and never imports, and ranges of parameters that are no ranges."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.facts import table
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_DYNAMIC = regex(r"\b(?:exec|eval|globals|locals|__import__|importlib|builtins)\b|\bvars\(")
_RANGES = {"floating_point_range": "FloatingPointRange", "integer_range": "IntegerRange"}
_FIELDS = ("from_value", "to_value", "step")


class Undefined(NamedTuple):
    name: ast.Name
    module: str
    """What to import it from; empty for a module itself."""
    function: str | None
    """Where it is used; None: when the file is imported."""
    stub: bool = False
    """The function says before it that it is not implemented."""


def undefined(syntax: Syntax) -> Iterator[Undefined]:
    """The first use of each name of the table that nothing in the file binds."""
    file = syntax.file
    if file.stars or _DYNAMIC.search(file.source.text):
        return
    names = {row["name"]: row["module"] for row in table("ros/names")}
    wanted = {name for name in names if name in file.source.text} - file.imports.keys()
    if not wanted:
        return
    bound: set[str] = set()
    used: dict[str, list[ast.Name]] = {}
    lazy = any(dotted == "__future__.annotations" for dotted in file.imports.values())
    for node in file.nodes:
        bound.update(_bound(node))
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load) and node.id in wanted:
            if not _is_harmless(syntax, node, lazy):
                used.setdefault(node.id, []).append(node)
    for name in sorted(used.keys() - bound):
        first = min(used[name], key=lambda each: (each.lineno, each.col_offset))
        yield Undefined(first, names[name], _function(syntax, first), _is_in_stub(syntax, first))


def _is_in_stub(syntax: Syntax, name: ast.Name) -> bool:
    function = syntax.function(name)
    before = (
        (each for each in ast.walk(function) if getattr(each, "lineno", name.lineno) < name.lineno) if function else ()
    )
    return any(_says_unfinished(each) for each in before)


def _says_unfinished(node: ast.AST) -> bool:
    if isinstance(node, ast.Name):
        return node.id == "NotImplementedError"
    text = node.value if isinstance(node, ast.Constant) else None
    return isinstance(text, str) and "not implemented" in text.lower()


def _bound(node: ast.AST) -> Iterator[str]:
    if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
        yield node.id
    elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
        yield node.name
    elif isinstance(node, ast.arg):
        yield node.arg
    elif isinstance(node, ast.ExceptHandler) and node.name:
        yield node.name
    elif isinstance(node, (ast.MatchAs, ast.MatchStar)) and node.name:
        yield node.name
    elif isinstance(node, (ast.Global, ast.Nonlocal)):
        yield from node.names


def _is_harmless(syntax: Syntax, node: ast.Name, lazy: bool) -> bool:
    """Whether the name is never looked up, or a NameError is expected."""
    for above, name in syntax.above(node):
        if lazy and name in ("annotation", "returns"):
            return True
        if isinstance(above, ast.Try) and name == "body":
            caught = {each.id for each in ast.walk(above) if isinstance(each, ast.Name)}
            if "NameError" in caught or any(handler.type is None for handler in above.handlers):
                return True
        if isinstance(above, ast.AnnAssign) and name == "annotation" and syntax.function(node) is not None:
            return True
    return False


def _function(syntax: Syntax, node: ast.AST) -> str | None:
    """The function whose call looks the name up; defaults, decorators and annotations are looked up at once."""
    for above, name in syntax.above(node):
        if isinstance(above, FUNCTIONS) and name == "body":
            return getattr(above, "name", "a lambda")
    return None


class DictRange(NamedTuple):
    """``floating_point_range=[{...}]``: ``values`` are the fields as they are written."""

    place: ast.expr
    type: str
    values: dict[str, ast.expr] | None
    """None when the dictionary has other keys than the type has fields."""


def dict_ranges(syntax: Syntax) -> Iterator[DictRange]:
    """Dictionaries where a descriptor of a parameter wants a range."""
    for node in syntax.file.nodes:
        if isinstance(node, ast.Call) and (syntax.qualified(node) or "").endswith(".ParameterDescriptor"):
            for keyword in node.keywords:
                if keyword.arg in _RANGES:
                    yield from _dicts(syntax, keyword.value, _RANGES[keyword.arg])
        elif isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Attribute):
            target = node.targets[0]
            made = syntax.file.named(target.value, syntax.function(node)) or ""
            if target.attr in _RANGES and made.endswith(".ParameterDescriptor"):
                yield from _dicts(syntax, node.value, _RANGES[target.attr])


def _dicts(syntax: Syntax, value: ast.expr, wanted: str) -> Iterator[DictRange]:
    if not isinstance(value, (ast.List, ast.Tuple)):
        return
    for element in value.elts:
        if isinstance(element, ast.Dict):
            keys = [key.value if isinstance(key, ast.Constant) else None for key in element.keys]
            yield DictRange(element, wanted, _fields(keys, element.values))
        elif isinstance(element, ast.Call) and isinstance(element.func, ast.Name) and element.func.id == "dict":
            names = [each.arg for each in element.keywords]
            fields = _fields(names, [each.value for each in element.keywords]) if not element.args else None
            yield DictRange(element, wanted, fields)


def _fields(keys: Sequence[object], values: list[ast.expr]) -> dict[str, ast.expr] | None:
    """The fields of a range by name; None when a key is not one of them."""
    names = [key for key in keys if isinstance(key, str) and key in _FIELDS]
    return dict(zip(names, values, strict=True)) if len(names) == len(keys) else None


def range_text(syntax: Syntax, found: DictRange) -> str | None:
    """The range object that the dictionary stands for; None when its values are not plain."""
    if found.values is None:
        return None
    words = []
    for name, value in found.values.items():
        text = syntax.file.span_of(value).text
        if found.type == "FloatingPointRange" and re.fullmatch(r"-?\d+", text):
            text += ".0"
        words.append(f"{name}={text}")
    return f"{found.type}({', '.join(words)})"
