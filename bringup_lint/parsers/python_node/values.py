"""Expressions of a node source, as far as they are constant."""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.python import PlacedNode
from bringup_lint.model.python import written
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
    values: Values | None = None
    """Those of the module in which the call is, where that is another one."""


class Read(NamedTuple):
    """The value of a parameter. ``default``: the literal one, or UNKNOWN."""

    name: Located
    default: Any


def _of_no_module(name: str) -> Any:
    """Stands for the modules of a file that is read alone."""
    return UNKNOWN


@dataclass(eq=False, slots=True)
class Values:
    """Evaluates the expressions of one file."""

    module: Module
    positions: Positions
    parameters: dict[int, dict[str, Any]]
    """Class (by ``id``) -> parameter -> declared default."""
    imported: Callable[[str], Any] = _of_no_module
    """The value of what is imported under a dotted name; UNKNOWN where no module of the tree makes it constant."""
    steps: int = 400_000
    """Expressions that are evaluated in one file."""
    _assigned: frozenset[tuple[str, str]] | None = field(default=None, init=False)

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
            return self._of_stars(node, scope) if name is None else self._symbol(name)
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
                return UNKNOWN if _is_enum(local) else self._class_constant(local, node.attr, depth)
        if node.attr in ("name", "value") and isinstance(owner, ast.Attribute) and isinstance(owner.value, ast.Name):
            enum = self.module.classes.get(owner.value.id)
            if enum is not None and _is_enum(enum):
                return self._member(enum, owner.attr, node.attr, depth)
        name = self.qualified(node, scope)
        if name is not None:
            return Symbol(name) if self._is_set(node) else self._symbol(name)
        if node.attr in _VALUES:
            inner = self.of(owner, scope, depth)
            return inner if isinstance(inner, Read) else UNKNOWN
        return self._of_stars(node, scope)

    def _symbol(self, name: str) -> Any:
        value = self.imported(name)
        return Symbol(name) if value is UNKNOWN else value

    def _of_stars(self, node: ast.Name | ast.Attribute, scope: Scope) -> Any:
        """What a name means, or an attribute of it, that nothing but ``from module import *`` can bind."""
        path = _path(node) if self.module.stars else []
        if not path or path[0].startswith("_") or scope.binding(path[0]) or path[0] in self.module.imports:
            return UNKNOWN
        dotted = (".".join([star.rstrip(".") if star.strip(".") else star[1:], *path]) for star in self.module.stars)
        found = [value for value in map(self.imported, dotted) if value is not UNKNOWN]
        return found[0] if len(found) == 1 else UNKNOWN

    def _is_set(self, node: ast.Attribute) -> bool:
        """Whether the file gives an attribute of something imported another value."""
        if self._assigned is None:
            scopes = (self.module.scope, *self.module.scopes.values())
            self._assigned = frozenset(
                (name, each.field) for scope in scopes for name in scope.sets for each in scope.sets[name]
            )
        return isinstance(node.value, ast.Name) and (node.value.id, node.attr) in self._assigned

    def exported(self, path: list[str]) -> Any:
        """The value of a name of the module, or of a class in it, for a file that imports it: one that means the same
        there."""
        node: ast.expr = ast.Name(path[0])
        for name in path[1:]:
            node = ast.Attribute(node, name)
        value = self.of(node, self.module.scope)
        if isinstance(value, Called):
            known = value.name.startswith("rclpy.") and not self.module.scope.sets.get(path[0])
            return value._replace(values=value.values or self) if known else UNKNOWN
        if isinstance(value, Symbol):
            top = value.name.partition(".")[0]
            return value if top and top not in self.module.classes else UNKNOWN
        return UNKNOWN if isinstance(value, Read) else value

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
        sets = cls.outer.sets.get(cls.node.name, ())
        if len(found) != 1 or found[0] is None or any(each.field == name for each in sets):
            return UNKNOWN
        return self.of(found[0], cls.outer, depth)

    def _member(self, enum: ClassScope, name: str, field: str, depth: int) -> Any:
        """The name or value of a member of an enumeration."""
        found = enum.constants.get(name, ())
        if len(found) != 1 or found[0] is None:
            return UNKNOWN
        return self._class_constant(enum, name, depth) if field == "value" else Located(name, self.span(found[0]))

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


def _path(node: ast.AST) -> list[str]:
    """The parts of a dotted name; empty for anything else."""
    parts: list[str] = []
    while isinstance(node, ast.Attribute) and len(parts) < DEPTH:
        parts.append(node.attr)
        node = node.value
    return [node.id, *reversed(parts)] if isinstance(node, ast.Name) else []


def _is_enum(cls: ClassScope) -> bool:
    """Whether the members of a class are no texts or numbers, but have them as names and values."""
    return len(cls.node.bases) == 1 and written(cls.node.bases[0]).rpartition(".")[2] == "Enum"


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
