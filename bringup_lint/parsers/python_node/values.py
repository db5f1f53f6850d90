"""Expressions of a node source, as far as they are constant."""

from __future__ import annotations

import ast
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.model.python import PlacedNode
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_node.scopes import ClassScope
from bringup_lint.parsers.python_node.scopes import Module
from bringup_lint.parsers.python_node.scopes import Scope
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import located
from bringup_lint.source import Located
from bringup_lint.source import Span

UNKNOWN = object()
DEPTH = 40
LENGTH = 4_000
_PLAIN = ("string", "integer", "double", "bool", "string_array", "integer_array", "double_array", "bool_array")
_VALUES = frozenset({"value", *(f"{kind}_value" for kind in _PLAIN)})
"""Attributes that give the value of a parameter."""

_CONVERTED: dict[str, tuple[type, ...]] = {"str": (str,), "int": (int,), "float": (int, float)}
"""Calls that leave these values as they are."""


class Symbol(NamedTuple):
    """Something imported, by its dotted name."""

    name: str


class Called(NamedTuple):
    """The result of a call of something imported, or of a class of the file."""

    name: str
    call: ast.Call
    scope: Scope


class Read(NamedTuple):
    """The value of a parameter. ``default``: the literal one, or UNKNOWN."""

    name: Located
    default: Any


@dataclass(eq=False, slots=True)
class Values:
    """Evaluates the expressions of one file."""

    module: Module
    positions: Positions
    parameters: dict[int, dict[str, Any]]
    """Class (by ``id``) -> parameter -> declared default."""
    steps: int = 400_000
    """Expressions that are evaluated in one file."""

    def span(self, node: PlacedNode) -> Span:
        return self.positions.span(node)

    def qualified(self, node: ast.AST, scope: Scope | None = None) -> str | None:
        """The dotted name of a name or attribute; the bare name of a class of the file."""
        parts: list[str] = []
        while isinstance(node, ast.Attribute):
            parts.append(node.attr)
            node = node.value
        if not isinstance(node, ast.Name) or len(parts) > DEPTH:
            return None
        name = node.id
        if scope is not None and scope.binding(name) is not None and name not in self.module.classes:
            return None
        root = self.module.imports.get(name)
        if root is None:
            if name in self.module.imports or self.module.classes.get(name) is None:
                return None
            root = name
        elif name in self.module.scope.names:
            return None
        return ".".join([root, *reversed(parts)])

    def of(self, node: ast.AST, scope: Scope, depth: int = 0) -> Any:
        """A Located text, number, bool, None, list, Symbol, Called or Read; UNKNOWN for all else."""
        self.steps -= 1
        if depth > DEPTH or self.steps < 0:
            return UNKNOWN
        handler = getattr(self, f"_{type(node).__name__.lower()}", None)
        return UNKNOWN if handler is None else handler(node, scope, depth + 1)

    def _constant(self, node: ast.Constant, scope: Scope, depth: int) -> Any:
        if isinstance(node.value, str):
            return located(node.value, self.span(node))
        return node.value if node.value is None or isinstance(node.value, (bool, int, float)) else UNKNOWN

    def _name(self, node: ast.Name, scope: Scope, depth: int) -> Any:
        home = scope.binding(node.id)
        if home is None:
            name = self.qualified(node)
            return UNKNOWN if name is None else Symbol(name)
        if node.id in home.arguments or (home.parent is None and node.id in self.module.imports):
            return UNKNOWN
        found = home.names[node.id]
        if len(found) != 1 or found[0] is None:
            name = self.qualified(node)
            return UNKNOWN if name is None or len(found) != 1 else Symbol(name)
        return self.of(found[0], home, depth)

    def _attribute(self, node: ast.Attribute, scope: Scope, depth: int) -> Any:
        owner = node.value
        if isinstance(owner, ast.Name):
            if scope.cls is not None and owner.id == scope.self_name:
                return self._own(scope.cls, node.attr, depth)
            local = self.module.classes.get(owner.id)
            if local is not None:
                return self._class_constant(local, node.attr, depth)
        name = self.qualified(node, scope)
        if name is not None:
            return Symbol(name)
        if node.attr in _VALUES:
            inner = self.of(owner, scope, depth)
            return inner if isinstance(inner, Read) else UNKNOWN
        return UNKNOWN

    def _own(self, cls: ClassScope, name: str, depth: int) -> Any:
        """``self.name``: assigned once in the class, or a constant of the class or of what it builds on."""
        current: ClassScope | None = cls
        for _ in range(DEPTH):
            if current is None:
                break
            found = current.attributes.get(name, ())
            if found:
                if len(found) > 1 or found[0][0] is None or name in current.constants:
                    return UNKNOWN
                return self.of(found[0][0], found[0][1], depth)
            if name in current.constants:
                return self._class_constant(current, name, depth)
            current = current.base
        return UNKNOWN

    def _class_constant(self, cls: ClassScope, name: str, depth: int) -> Any:
        found = cls.constants.get(name, ())
        if len(found) != 1 or found[0] is None:
            return UNKNOWN
        return self.of(found[0], cls.outer, depth)

    def _call(self, node: ast.Call, scope: Scope, depth: int) -> Any:
        function = node.func
        if isinstance(function, ast.Attribute):
            if function.attr in ("get_parameter", "declare_parameter") and node.args:
                return self._parameter(node, function.attr, scope, depth)
            if function.attr == "get_parameter_value":
                inner = self.of(function.value, scope, depth)
                return inner if isinstance(inner, Read) else UNKNOWN
        elif isinstance(function, ast.Name) and function.id in _CONVERTED and len(node.args) == 1:
            inner = self.of(node.args[0], scope, depth)
            if isinstance(inner, Read):
                return inner
            return inner if isinstance(inner, _CONVERTED[function.id]) and not isinstance(inner, bool) else UNKNOWN
        name = self.qualified(function, scope)
        return UNKNOWN if name is None else Called(name, node, scope)

    def _parameter(self, node: ast.Call, method: str, scope: Scope, depth: int) -> Any:
        name = self.of(node.args[0], scope, depth)
        if not isinstance(name, Located):
            return UNKNOWN
        if method == "declare_parameter":
            default = node.args[1] if len(node.args) > 1 else keyword(node, "value")
            return Read(name, UNKNOWN if default is None else self.of(default, scope, depth))
        cls = scope.cls
        for _ in range(DEPTH):
            if cls is None:
                break
            declared = self.parameters.get(id(cls), {})
            if name in declared:
                return Read(name, declared[name])
            cls = cls.base
        return Read(name, UNKNOWN)

    def _joinedstr(self, node: ast.JoinedStr, scope: Scope, depth: int) -> Any:
        text = ""
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                if part.conversion != -1 or part.format_spec is not None:
                    return UNKNOWN
                part = part.value
            value = self.of(part, scope, depth) if not isinstance(part, ast.Constant) else part.value
            if isinstance(value, bool) or not isinstance(value, (str, int)) or len(text) > LENGTH:
                return UNKNOWN
            text += str(value)
        return Located(text, self.span(node))

    def _binop(self, node: ast.BinOp, scope: Scope, depth: int) -> Any:
        left, right = self.of(node.left, scope, depth), self.of(node.right, scope, depth)
        if isinstance(node.op, ast.Add) and isinstance(left, str) and isinstance(right, str):
            return Located(left + right, self.span(node)) if len(left) + len(right) < LENGTH else UNKNOWN
        if not is_number(left) or not is_number(right) or max(abs(left), abs(right)) > 1e18:
            return UNKNOWN
        if isinstance(node.op, ast.Add):
            return left + right
        if isinstance(node.op, ast.Sub):
            return left - right
        if isinstance(node.op, ast.Mult):
            return left * right
        if isinstance(node.op, ast.Div) and right:
            return left / right
        return UNKNOWN

    def _unaryop(self, node: ast.UnaryOp, scope: Scope, depth: int) -> Any:
        value = self.of(node.operand, scope, depth)
        return -value if isinstance(node.op, ast.USub) and is_number(value) else UNKNOWN

    def _list(self, node: ast.List | ast.Tuple, scope: Scope, depth: int) -> Any:
        if len(node.elts) > LENGTH:
            return UNKNOWN
        values = [self.of(element, scope, depth) for element in node.elts]
        plain = all(value is not UNKNOWN and not isinstance(value, (Symbol, Called, Read)) for value in values)
        return values if plain else UNKNOWN

    _tuple = _list


def is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def keyword(call: ast.Call, name: str) -> ast.expr | None:
    return next((each.value for each in call.keywords if each.arg == name), None)


def argument(call: ast.Call, index: int, *names: str) -> ast.expr | None:
    """A positional argument, or the keyword of one of the names; None behind a ``*sequence``."""
    if 0 <= index < len(call.args):
        if any(isinstance(each, ast.Starred) for each in call.args[: index + 1]):
            return None
        return call.args[index]
    return next((found for name in names if (found := keyword(call, name)) is not None), None)
