"""Which message an expression of a node source is."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.graph.nodes.resolved.interface_fields import InterfaceFields
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import is_self
from bringup_lint.model.python import walk
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple

DEPTH = 12
VALUES = 16
"""Values of one name that are looked at."""
_BINDING = frozenset(
    (
        *(ast.Assign, ast.AnnAssign, ast.AugAssign, ast.NamedExpr, ast.Delete),
        *(ast.For, ast.AsyncFor, ast.comprehension, ast.withitem, ast.ExceptHandler),
        *(ast.arg, ast.Global, ast.Nonlocal),
    )
)
_GOAL_HANDLE = "_GoalHandle"
_SECTIONS = {"srv": ("Request", "Response"), "action": ("Goal", "Result", "Feedback")}


class Bound(NamedTuple):
    """What binds a name: a value, an element of one, or (None) something unknown."""

    value: ast.expr | None
    element: bool = False


class MessageTypes:
    """The types of the expressions of one file, as ``geometry_msgs/msg/Twist``; arrays end with ``[]``."""

    def __init__(self, syntax: Syntax, interfaces: InterfaceFields) -> None:
        self.syntax = syntax
        self.file = syntax.file
        self.interfaces = interfaces
        self._names: dict[ast.AST, dict[str, list[Bound]]] = {}
        self._attributes: dict[ast.ClassDef, dict[str, list[Bound]]] = {}
        self._arguments: dict[ast.AST, dict[str, str | None]] = {}
        for cls in self.file.classes:
            self._take_callbacks(cls)

    def of(self, node: ast.expr, depth: int = 0) -> str | None:
        if depth > DEPTH:
            return None
        if isinstance(node, ast.Call):
            return self.made(node)
        if isinstance(node, ast.Name):
            return self._name(node, depth + 1)
        if isinstance(node, ast.Subscript):
            inner = self.of(node.value, depth + 1)
            single = inner is not None and inner.endswith("[]") and not isinstance(node.slice, ast.Slice)
            return inner[:-2] if inner is not None and single else None
        if isinstance(node, ast.Attribute):
            if is_self(node.value):
                return self._attribute(node, depth + 1)
            owner = self.of(node.value, depth + 1)
            return self._field(owner, node.attr) if owner is not None else None
        return None

    def made(self, call: ast.Call) -> str | None:
        """The message that a call makes: ``Twist()``, ``SetBool.Request()``."""
        return message_type(self.file.qualified(call.func))

    def bound(self, node: ast.Name) -> ast.expr | None:
        """The one value that a function binds to a local name."""
        function = self.syntax.function(node)
        bound = self._bindings(function).get(node.id, ()) if function is not None else ()
        return bound[0].value if len(bound) == 1 and not bound[0].element else None

    def kept(self, node: ast.Attribute) -> ast.expr | None:
        """The one value that a class assigns to an attribute of its own."""
        outer = self.syntax.definition(node) if is_self(node.value) else None
        if outer is None or node.attr in self._foreign:
            return None
        bound = self._set_in(outer).get(node.attr, ())
        return bound[0].value if len(bound) == 1 and not bound[0].element else None

    def values(self, node: ast.expr) -> list[ast.expr]:
        """All that a function binds to a local name, or a class to an attribute of its own; empty where part of that is
        not known, or very much."""
        function, outer = self.syntax.function(node), self.syntax.definition(node)
        found: list[Bound] | tuple[()] = ()
        if isinstance(node, ast.Name) and function is not None and node.id not in self._arguments.get(function, {}):
            found = self._bindings(function).get(node.id, ())
        elif isinstance(node, ast.Attribute) and is_self(node.value) and outer is not None:
            found = self._set_in(outer).get(node.attr, ()) if node.attr not in self._foreign else ()
        if len(found) > VALUES:
            return []
        known = [each.value for each in found if each.value is not None and not each.element]
        return known if len(known) == len(found) else []

    def _field(self, owner: str, name: str) -> str | None:
        if owner.endswith(_GOAL_HANDLE):
            return f"{owner.removesuffix(_GOAL_HANDLE)}_Goal" if name == "request" else None
        kind = (self.interfaces.fields(owner) or {}).get(name, "")
        if "/" not in kind:
            return kind or None
        package, _, rest = kind.partition("/")
        return kind if "/" in rest else f"{package}/msg/{rest}"

    def _name(self, node: ast.Name, depth: int) -> str | None:
        function = self.syntax.function(node)
        if function is None:
            return None
        arguments = self._arguments.get(function, {})
        bound = self._bindings(function).get(node.id, ())
        if node.id in arguments:
            return arguments[node.id] if not bound else None
        return self._common(bound, depth)

    def _attribute(self, node: ast.Attribute, depth: int) -> str | None:
        """``self.x``, when all that its class assigns is of one type."""
        outer = self.syntax.definition(node)
        if outer is None or node.attr in self._foreign:
            return None
        bound = self._set_in(outer).get(node.attr, ())
        return self._common([each for each in bound if not _is_none(each.value)], depth)

    def _common(self, bound: list[Bound] | tuple[()], depth: int) -> str | None:
        types = set()
        for each in bound:
            kind = self.of(each.value, depth) if each.value is not None else None
            if each.element:
                kind = kind[:-2] if kind is not None and kind.endswith("[]") else None
            types.add(kind)
            if None in types:
                return None
        return types.pop() if len(types) == 1 else None

    def _bindings(self, function: ast.AST) -> dict[str, list[Bound]]:
        """What binds each name of a function, but the arguments whose type is known."""
        if function not in self._names:
            known = self._arguments.get(function, {})
            found: dict[str, list[Bound]] = {}
            for node in _binding(function):
                for target, value in _targets(node):
                    if isinstance(target, ast.Name):
                        found.setdefault(target.id, []).append(value)
                for name in _opaque(node):
                    found.setdefault(name, []).append(Bound(None))
            for each in getattr(getattr(function, "args", None), "args", ()):
                if each.arg in known:
                    found[each.arg].remove(Bound(None))
            self._names[function] = found
        return self._names[function]

    def _set_in(self, outer: ast.ClassDef) -> dict[str, list[Bound]]:
        if outer not in self._attributes:
            found: dict[str, list[Bound]] = {}
            for node in _binding(outer):
                for target, value in _targets(node):
                    if isinstance(target, ast.Attribute) and isinstance(target.value, ast.Name):
                        found.setdefault(target.attr, []).append(value)
                    elif isinstance(target, ast.Name) and node in outer.body:
                        found.setdefault(target.id, []).append(value)
            self._attributes[outer] = found
        return self._attributes[outer]

    @cached_property
    def _foreign(self) -> frozenset[str]:
        """Attributes that are set on something else than ``self``."""
        stored = (
            each for each in self.file.nodes if isinstance(each, ast.Attribute) and isinstance(each.ctx, ast.Store)
        )
        return frozenset(each.attr for each in stored if not is_self(each.value))

    def _take_callbacks(self, cls: NodeClass) -> None:
        """The types of the arguments of callbacks."""
        if "raw=True" in self.file.source.text:
            return
        for endpoint in cls.endpoints:
            given = _given(endpoint)
            if given:
                self._take(cls, endpoint.callback or "", given)
        for name, action in self._feedback(cls):
            self._take(cls, name, [f"{action}_FeedbackMessage"])

    def _take(self, cls: NodeClass, callback: str, given: list[str]) -> None:
        """The types of what a callback is given."""
        method = cls.methods.get(callback)
        if method is None or _looks_at_type(method.node):
            return
        names = [each.arg for each in method.node.args.args][1:]
        taken = self._arguments.setdefault(method.node, {})
        for name, kind in zip(names, given, strict=False):
            taken[name] = kind if taken.get(name, kind) == kind else None

    def _feedback(self, cls: NodeClass) -> Iterator[tuple[str, str]]:
        """The methods that ``send_goal_async`` of a client is given for the feedback, each with the action."""
        actions = {each.attribute: each.type for each in cls.endpoints if each.role == "action-client" and each.type}
        if not actions:
            return
        for call in self.syntax.calls:
            given = next((each.value for each in call.keywords if each.arg == "feedback_callback"), None)
            if not isinstance(given, ast.Attribute) or not is_self(given.value):
                continue
            action = actions.get(written(call.func.value)) if isinstance(call.func, ast.Attribute) else None
            if action and self.syntax.class_of(call) is cls:
                yield given.attr, action


def types_of(file: NodeSource, syntax: Syntax, interfaces: InterfaceFields) -> MessageTypes | None:
    """None for a file that imports no message."""
    modules = (name or "" for name in file.imports.values())
    if not any(".msg" in name or ".srv" in name or ".action" in name for name in modules):
        return None
    return MessageTypes(syntax, interfaces)


def message_type(dotted: str | None) -> str | None:
    """``geometry_msgs.msg.Twist``, ``std_srvs.srv.SetBool.Request`` -> the type; None for all else."""
    parts = (dotted or "").split(".")
    if len(parts) == 3 and parts[1] == "msg":
        return "/".join(parts)
    if len(parts) == 4 and parts[3] in _SECTIONS.get(parts[1], ()):
        return f"{parts[0]}/{parts[1]}/{parts[2]}_{parts[3]}"
    return None


def sections_of(dotted: str | None) -> list[str]:
    """``std_srvs.srv.SetBool`` -> the types of its parts; empty for all else."""
    parts = (dotted or "").split(".")
    if len(parts) != 3:
        return []
    return [f"{'/'.join(parts)}_{each}" for each in _SECTIONS.get(parts[1], ())]


def _given(endpoint: Endpoint) -> list[str]:
    """The types of what the callback of an endpoint is given; none where that is not known."""
    if endpoint.type is None:
        return []
    if endpoint.role == "service":
        return _sections(endpoint.type)
    if endpoint.role == "action-server":
        return [endpoint.type + _GOAL_HANDLE]
    return [endpoint.type] if endpoint.role == "subscription" else []


def _sections(service: str) -> list[str]:
    return [f"{service}_Request", f"{service}_Response"]


def _looks_at_type(function: FunctionNode) -> bool:
    """Whether a function asks of which type one of its arguments is."""
    taken = {each.arg for each in function.args.args}
    calls = (each for each in walk(function) if isinstance(each, ast.Call) and each.args)
    asked = (each.args[0] for each in calls if getattr(each.func, "id", "") in ("isinstance", "hasattr", "type"))
    return any(isinstance(each, ast.Name) and each.id in taken for each in asked)


def _is_none(value: ast.expr | None) -> bool:
    return isinstance(value, ast.Constant) and value.value is None


def _binding(top: ast.AST) -> Iterator[ast.AST]:
    """What may bind a name in a piece of syntax."""
    return (node for node in walk(top) if type(node) in _BINDING)


def _targets(node: ast.AST) -> Iterator[tuple[ast.expr, Bound]]:
    """What a statement binds, each with the value."""
    if isinstance(node, ast.Assign):
        for target in node.targets:
            yield from _parts(target, Bound(node.value))
    elif isinstance(node, ast.AnnAssign) and node.value is not None:
        yield from _parts(node.target, Bound(node.value))
    elif isinstance(node, (ast.For, ast.AsyncFor, ast.comprehension)):
        yield from _parts(node.target, Bound(node.iter, element=True))
    elif isinstance(node, (ast.AugAssign, ast.NamedExpr)):
        yield from _parts(node.target, Bound(None))
    elif isinstance(node, ast.withitem) and node.optional_vars is not None:
        yield from _parts(node.optional_vars, Bound(None))
    elif isinstance(node, ast.Delete):
        yield from ((target, Bound(None)) for target in node.targets)


def _opaque(node: ast.AST) -> Iterator[str]:
    """The names that a node binds to something of which nothing is known."""
    if isinstance(node, ast.arg):
        yield node.arg
    elif isinstance(node, (ast.Global, ast.Nonlocal)):
        yield from node.names
    elif isinstance(node, ast.ExceptHandler) and node.name:
        yield node.name


def _parts(target: ast.expr, bound: Bound) -> Iterator[tuple[ast.expr, Bound]]:
    if isinstance(target, (ast.Tuple, ast.List)):
        for each in target.elts:
            yield from _parts(each, Bound(None))
    elif isinstance(target, ast.Starred):
        yield from _parts(target.value, Bound(None))
    else:
        yield target, bound
