"""Ranges of parameters that are written as dictionaries, where a descriptor wants objects."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from collections.abc import Sequence

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.named_tuple import NamedTuple

_RANGES = {"floating_point_range": "FloatingPointRange", "integer_range": "IntegerRange"}
_FIELDS = ("from_value", "to_value", "step")


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
