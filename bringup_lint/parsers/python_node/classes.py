"""The classes of nodes in a file: what they build on, how they are called, which parameters they declare."""

from __future__ import annotations

import ast
import builtins
import sys
from typing import Any

from bringup_lint.model.node_source import Function
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import Parameter
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import PlacedNode
from bringup_lint.model.python import walk
from bringup_lint.parsers.python_node.scopes import Call
from bringup_lint.parsers.python_node.scopes import ClassScope
from bringup_lint.parsers.python_node.scopes import Scope
from bringup_lint.parsers.python_node.values import UNKNOWN
from bringup_lint.parsers.python_node.values import Called
from bringup_lint.parsers.python_node.values import Read
from bringup_lint.parsers.python_node.values import Symbol
from bringup_lint.parsers.python_node.values import Values
from bringup_lint.parsers.python_node.values import argument
from bringup_lint.source import Located
from bringup_lint.source import Span

PLAIN = ("rclpy.node.Node", "rclpy.create_node")
LIFECYCLE = (
    "rclpy.lifecycle.Node",
    "rclpy.lifecycle.LifecycleNode",
    "rclpy.lifecycle.node.LifecycleNode",
)
ROOTS = (*PLAIN, *LIFECYCLE)
_DEPTH = 12


def node_class(values: Values, scope: ClassScope) -> NodeClass:
    """The class with its bases and methods; endpoints are filled in later."""
    node = scope.node
    span = values.span(node)
    source = span.source
    at = source.text.find(node.name, span.start)
    name = Located(node.name, Span(source, at, at + len(node.name)))
    bases = tuple(values.qualified(base) or _text(base) for base in node.bases)
    found = NodeClass(source, name, span, bases, node=node)
    found.methods = {key: function(values, method) for key, method in scope.methods.items()}
    return found


def function(values: Values, node: FunctionNode) -> Function:
    span = values.span(node)
    at = span.source.text.find(node.name, span.start)
    decorators = tuple(values.qualified(each) or _text(each) for each in node.decorator_list)
    return Function(Located(node.name, Span(span.source, at, at + len(node.name))), node, span, decorators)


def _text(node: ast.expr) -> str:
    if isinstance(node, ast.Call):
        node = node.func
    parts: list[str] = []
    while isinstance(node, ast.Attribute) and len(parts) < _DEPTH:
        parts.append(node.attr)
        node = node.value
    return ".".join([node.id, *reversed(parts)]) if isinstance(node, ast.Name) else ""


def judge(found: NodeClass, depth: int = 0) -> None:
    """Say whether it is a class of nodes, by what it builds on."""
    answers = [_is_node(base, found, depth) for base in found.bases]
    found.is_node = True if True in answers else None if None in answers else False
    found.is_lifecycle = any(base in LIFECYCLE for base in found.bases) or any(
        each.is_lifecycle for each in found.lineage if each is not found
    )


def _is_node(base: str, found: NodeClass, depth: int) -> bool | None:
    if base in ROOTS:
        return True
    if found.base is not None and found.base.name == base and depth < _DEPTH:
        judge(found.base, depth + 1)
        return found.base.is_node
    root = base.partition(".")[0]
    if root in sys.stdlib_module_names or (root == base and hasattr(builtins, root)) or base in ("ABC", "Enum"):
        return False
    return None


def declare(values: Values, call: Call, method: str) -> list[Parameter]:
    """The parameters that a call of ``declare_parameter`` or ``declare_parameters`` declares."""
    node, scope = call.node, call.scope
    if method == "declare_parameter":
        return _declared(values, node, argument(node, 0, "name"), argument(node, 1, "value"), scope, "")
    namespace = argument(node, 0, "namespace")
    prefix = values.of(namespace, scope) if namespace is not None else UNKNOWN
    rows = argument(node, 1, "parameters")
    if not isinstance(prefix, str) or not isinstance(rows, (ast.List, ast.Tuple)):
        return []
    found = []
    for row in rows.elts:
        if isinstance(row, (ast.Tuple, ast.List)) and row.elts:
            default = row.elts[1] if len(row.elts) > 1 else None
            found += _declared(values, row, row.elts[0], default, scope, f"{prefix}." if prefix else "")
    return found


def _declared(
    values: Values, node: PlacedNode, name: ast.expr | None, default: ast.expr | None, scope: Scope, prefix: str
) -> list[Parameter]:
    text = values.of(name, scope) if name is not None else UNKNOWN
    if not isinstance(text, Located):
        return []
    value: Any = values.of(default, scope) if default is not None else UNKNOWN
    known = value is not UNKNOWN and not isinstance(value, (Symbol, Called, Read))
    return [Parameter(Located(prefix + text, text.span), value if known else None, known, values.span(node))]


def given_name(values: Values, scope: ClassScope, call: ast.Call | None, at: Scope, keyword: str) -> Any:
    """The node name (``keyword`` ``node_name``, position 0) or namespace that an instance gets; UNKNOWN when it is not
    literal. ``call`` makes the instance; None: without arguments that are known."""
    current = scope
    for _ in range(_DEPTH):
        init = current.methods.get("__init__")
        if init is None:
            if current.base is None:
                return _argument(values, call, at, keyword) if call is not None else UNKNOWN
            current = current.base
            continue
        inner = current.scopes["__init__"]
        upper = _super_call(init, current)
        if upper is None:
            return UNKNOWN
        given = _argument_node(upper, keyword)
        if current.base is not None:
            call, at, current = upper, inner, current.base
            continue
        if given is None:
            return UNKNOWN
        if isinstance(given, ast.Name) and given.id in inner.arguments:
            return _handed(values, init, given.id, call, at)
        return values.of(given, inner)
    return UNKNOWN


def _argument(values: Values, call: ast.Call, at: Scope, keyword: str) -> Any:
    node = _argument_node(call, keyword)
    return UNKNOWN if node is None else values.of(node, at)


def _argument_node(call: ast.Call, keyword: str) -> ast.expr | None:
    return argument(call, 0 if keyword == "node_name" else 99, keyword)


def _handed(values: Values, init: FunctionNode, name: str, call: ast.Call | None, at: Scope) -> Any:
    """What a parameter of the constructor is given by the call, or its default."""
    positional = [*init.args.posonlyargs, *init.args.args]
    names = [each.arg for each in positional]
    if call is not None:
        index = names.index(name) - 1 if name in names else 99
        given = argument(call, index, name)
        if given is not None:
            return values.of(given, at)
        if any(each.arg is None for each in call.keywords) or any(isinstance(each, ast.Starred) for each in call.args):
            return UNKNOWN
    defaults: dict[str, ast.expr | None] = dict(zip(reversed(names), reversed(init.args.defaults), strict=False))
    defaults |= {key.arg: value for key, value in zip(init.args.kwonlyargs, init.args.kw_defaults, strict=True)}
    default = defaults.get(name)
    return UNKNOWN if default is None else values.of(default, at)


def _super_call(init: FunctionNode, scope: ClassScope) -> ast.Call | None:
    """``super().__init__(...)`` or ``Base.__init__(self, ...)``, with ``self`` left out."""
    for node in walk(init):
        if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Attribute) or node.func.attr != "__init__":
            continue
        owner = node.func.value
        if isinstance(owner, ast.Call) and isinstance(owner.func, ast.Name) and owner.func.id == "super":
            return node
        if node.args and isinstance(node.args[0], ast.Name) and node.args[0].id == scope.scopes["__init__"].self_name:
            return ast.Call(node.func, node.args[1:], node.keywords)
    return None
