"""Quaternions that go from one library or message to another with their numbers in the wrong order."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from collections.abc import Iterator
from itertools import islice

from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

SCALAR_FIRST, SCALAR_LAST = "wxyz", "xyzw"
_LIBRARIES = {
    "transforms3d": SCALAR_FIRST,
    "tf_transformations": SCALAR_LAST,
    "tf.transformations": SCALAR_LAST,
}
"""The order of the numbers (transforms3d, quaternions.py; tf_transformations, __init__.py)."""
_MAKES = frozenset(
    "euler2quat mat2quat axangle2quat quaternion_from_euler quaternion_from_matrix quaternion_about_axis".split()
)
_TAKES = frozenset("quat2euler quat2mat quat2axangle euler_from_quaternion quaternion_matrix".split())
_LETTER = regex(r"(?:.*_)?q?_?([wxyz])\Z")


_MOST = 12
"""Calls of a library in one file that are looked at."""


class Misordered(NamedTuple):
    place: ast.expr
    function: str
    """The function of the library."""
    order: str
    """The order of its library."""
    found: str
    """The order in which the numbers are taken or given."""


def misordered_quaternions(syntax: Syntax) -> Iterator[Misordered]:
    text = syntax.file.source.text
    if not any(library in text for library in _LIBRARIES):
        return
    known = ((call, *_of_library(syntax, call)) for call in syntax.calls)
    for call, function, order in islice((each for each in known if each[-1]), _MOST):
        name = function.rpartition(".")[2]
        if name in _TAKES and call.args:
            found = _given(syntax, call.args[0])
            if found is not None and found != order:
                yield Misordered(call.args[0], name, order, found)
        elif name in _MAKES:
            taken = _taken(syntax, call)
            if taken is not None and taken[1] != order:
                yield Misordered(taken[0], name, order, taken[1])


def _of_library(syntax: Syntax, call: ast.Call) -> tuple[str, str]:
    """The dotted name of a function, and the order of its library; empty where there is none."""
    name = syntax.qualified(call) or ""
    orders = (order for library, order in _LIBRARIES.items() if name.startswith(f"{library}."))
    return name, next(orders, "")


def _given(syntax: Syntax, value: ast.expr) -> str | None:
    """The order of ``[q.x, q.y, q.z, q.w]``, also by a name that the function gives one value."""
    if isinstance(value, ast.Name):
        stores = _stores(syntax, value)
        outer = next(syntax.above(stores[0]), (None, ""))[0] if len(stores) == 1 else None
        if not isinstance(outer, ast.Assign):
            return None
        value = outer.value
    if not isinstance(value, (ast.List, ast.Tuple)) or not all(isinstance(each, ast.Attribute) for each in value.elts):
        return None
    owners = {written(each.value) for each in value.elts if isinstance(each, ast.Attribute)}
    found = _order(each.attr for each in value.elts if isinstance(each, ast.Attribute))
    return found if len(owners) == 1 else None


def _stores(syntax: Syntax, name: ast.Name) -> list[ast.Name]:
    inside = own(body_of(syntax.function(name)))
    return [
        each for each in inside if isinstance(each, ast.Name) and each.id == name.id and isinstance(each.ctx, ast.Store)
    ]


def _order(letters: Iterable[str]) -> str | None:
    found = "".join(letters)
    return found if found in (SCALAR_FIRST, SCALAR_LAST) else None


def _taken(syntax: Syntax, call: ast.Call) -> tuple[ast.expr, str] | None:
    """What the numbers of a new quaternion become: ``x, y, z, w = ...``, or ``orientation.x = q[0]`` and the others."""
    outer = next(syntax.above(call), (None, ""))[0]
    if not isinstance(outer, ast.Assign) or len(outer.targets) != 1:
        return None
    target = outer.targets[0]
    if isinstance(target, (ast.Tuple, ast.List)):
        matches = [_LETTER.match(written(each).replace(".", "_")) for each in target.elts]
        found = _order(each[1] if each is not None else "?" for each in matches)
        return (target, found) if found is not None else None
    if not isinstance(target, ast.Name) or len(_stores(syntax, target)) != 1 or _is_changed(syntax, target):
        return None
    places = dict(_fields(syntax, target))
    letters = sorted(places, key=lambda letter: places[letter][1])
    found = _order(letters) if [places[each][1] for each in letters] == list(range(4)) else None
    return (places[letters[0]][0], found) if found is not None else None


def _is_changed(syntax: Syntax, quaternion: ast.Name) -> bool:
    """Whether single numbers are written, or a statement hands the whole to what may put them into another order."""
    for node in own(body_of(syntax.function(quaternion))):
        if isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Store) and _is(node.value, quaternion):
            return True
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call):
            method = node.value.func.value if isinstance(node.value.func, ast.Attribute) else None
            if any(_is(each, quaternion) for each in (*node.value.args, method)):
                return True
    return False


def _is(node: ast.expr | None, name: ast.Name) -> bool:
    return isinstance(node, ast.Name) and node.id == name.id


def _fields(syntax: Syntax, quaternion: ast.Name) -> Iterator[tuple[str, tuple[ast.expr, int]]]:
    """Field -> where it gets an element of the quaternion, and which."""
    for node in own(body_of(syntax.function(quaternion))):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Attribute):
            index = _index(node.value, quaternion.id)
            if index is not None:
                yield node.targets[0].attr, (node.targets[0], index)
        elif isinstance(node, ast.keyword) and node.arg is not None:
            index = _index(node.value, quaternion.id)
            if index is not None:
                yield node.arg, (node.value, index)


def _index(value: ast.expr, name: str) -> int | None:
    """The number in ``q[0]``, also inside of ``float(q[0])``."""
    while isinstance(value, ast.Call) and len(value.args) == 1:
        value = value.args[0]
    if not isinstance(value, ast.Subscript) or not isinstance(value.value, ast.Name) or value.value.id != name:
        return None
    index = value.slice
    return index.value if isinstance(index, ast.Constant) and type(index.value) is int else None
