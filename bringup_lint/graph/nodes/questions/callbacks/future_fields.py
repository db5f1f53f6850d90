"""Fields of a response that are read of the future itself."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator

from bringup_lint.graph.nodes.questions.callbacks.early_results import ASKS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import is_self
from bringup_lint.named_tuple import NamedTuple

_OF_FUTURE = frozenset(
    "add_done_callback cancel cancelled done exception executing result set_exception set_executor set_result "
    "remove_pending_request".split()
)
"""What a future of rclpy has. Source: rclpy/task.py."""


class FieldOfFuture(NamedTuple):
    asked: ast.Call
    read: ast.Attribute


def fields_of_futures(syntax: Syntax) -> Iterator[FieldOfFuture]:
    """The first field in each function that a future of a service or action does not have."""
    futures: dict[FunctionNode, dict[str, ast.Call]] = {}
    for call in syntax.calls:
        if not isinstance(call.func, ast.Attribute) or call.func.attr not in ASKS or is_self(call.func.value):
            continue
        outer = next(syntax.above(call), (None, ""))[0]
        function = syntax.function(call)
        if isinstance(outer, ast.Assign) and isinstance(outer.targets[0], ast.Name) and function is not None:
            futures.setdefault(function, {})[outer.targets[0].id] = call
    for function, named in futures.items():
        yield from _of_function(function, named)


def _of_function(function: FunctionNode, futures: dict[str, ast.Call]) -> Iterator[FieldOfFuture]:
    names: list[ast.Name] = []
    fields: list[tuple[str, ast.Attribute]] = []
    for each in own(function.body):
        if isinstance(each, ast.Name):
            names.append(each)
        elif isinstance(each, ast.Attribute) and isinstance(each.value, ast.Name):
            fields.append((each.value.id, each))
    stored = Counter(each.id for each in names if not isinstance(each.ctx, ast.Load))
    given = {each.attr for _, each in fields if isinstance(each.ctx, ast.Store)}
    for name, each in fields:
        if name in futures and stored[name] == 1 and not _has(each.attr, given):
            yield FieldOfFuture(futures[name], each)
            return


def _has(attribute: str, given: set[str]) -> bool:
    """Whether a future has an attribute, or the code gives it one."""
    return attribute in _OF_FUTURE or attribute in given or attribute.startswith("_")
