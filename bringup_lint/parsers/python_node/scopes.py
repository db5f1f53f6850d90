"""Names of a Python file: what is bound where, and by what. A name counts as known when it is bound exactly once."""

from __future__ import annotations

import ast
from collections.abc import Callable
from collections.abc import Iterator
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.python import FunctionNode
from bringup_lint.model.python import fields_of
from bringup_lint.named_tuple import NamedTuple

NODES = 400_000
"""Syntax nodes of a file that are looked at."""
Kept = dict[int, ast.expr]
"""``id`` of a call -> what its result is assigned to."""


class AttributeSet(NamedTuple):
    """``owner.field = value``, for profiles that are filled in after they are made."""

    field: str
    value: ast.expr
    scope: Scope
    conditional: bool


@dataclass(eq=False, slots=True)
class ClassScope:
    node: ast.ClassDef
    outer: Scope
    constants: dict[str, list[ast.expr | None]] = field(default_factory=dict)
    attributes: dict[str, list[tuple[ast.expr | None, Scope]]] = field(default_factory=dict)
    """``self.x = ...`` in any method."""
    sets: dict[str, list[AttributeSet]] = field(default_factory=dict)
    """``self.x.field = ...``."""
    methods: dict[str, FunctionNode] = field(default_factory=dict)
    scopes: dict[str, Scope] = field(default_factory=dict)
    base: ClassScope | None = None


@dataclass(eq=False, slots=True)
class Scope:
    """A module or a function. ``names``: the expressions that a name is bound to; None where there is no expression."""

    node: ast.Module | FunctionNode
    parent: Scope | None = None
    cls: ClassScope | None = None
    """The class whose method this is, or is nested in."""
    self_name: str | None = None
    names: dict[str, list[ast.expr | None]] = field(default_factory=dict)
    sets: dict[str, list[AttributeSet]] = field(default_factory=dict)
    arguments: frozenset[str] = frozenset()

    def binding(self, name: str) -> Scope | None:
        """The scope that binds a name, from here outwards."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.names:
                return scope
            scope = scope.parent
        return None

    @property
    def label(self) -> str | None:
        """The function's name; of a nested one, that of the method it is in."""
        scope: Scope | None = self
        label = None
        while scope is not None and not isinstance(scope.node, ast.Module):
            label = scope.node.name
            scope = scope.parent
        return label


class Call(NamedTuple):
    node: ast.Call
    scope: Scope
    conditional: bool
    kept: ast.expr | None
    """What the result is assigned to."""


@dataclass(eq=False, slots=True)
class Module:
    scope: Scope
    imports: dict[str, str | None] = field(default_factory=dict)
    stars: list[str] = field(default_factory=list)
    classes: dict[str, ClassScope | None] = field(default_factory=dict)
    """Classes by name; None when two have it."""
    all_classes: list[ClassScope] = field(default_factory=list)
    functions: dict[str, FunctionNode] = field(default_factory=dict)
    calls: list[Call] = field(default_factory=list)
    main: str | None = None
    scopes: dict[int, Scope] = field(default_factory=dict)
    """Every function, by the ``id`` of its syntax node."""
    complete: bool = True
    """False when the file is too long to be read to the end."""


class Todo(NamedTuple):
    node: ast.AST
    scope: Scope
    cls: ClassScope | None
    """The class body in which the node is directly."""
    conditional: bool


def read_module(tree: ast.Module) -> Module:
    """All names and calls of a file, in the order of the text."""
    module = Module(Scope(tree))
    stack = [Todo(node, module.scope, None, False) for node in reversed(tree.body)]
    kept: Kept = {}
    count = 0
    while stack:
        todo = stack.pop()
        count += 1
        if count > NODES:
            module.complete = False
            break
        node = todo.node
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            children = _function(module, todo, node)
        elif isinstance(node, ast.ClassDef):
            children = _class(module, todo, node)
        else:
            if isinstance(node, ast.Call):
                module.calls.append(Call(node, todo.scope, todo.conditional, kept.get(id(node))))
            elif type(node) in _BINDERS:
                _BINDERS[type(node)](module, todo, node, kept)
            children = _children(module, todo)
        stack.extend(reversed(list(children)))
    _link_bases(module)
    return module


def _function(module: Module, todo: Todo, node: FunctionNode) -> Iterator[Todo]:
    inner = Scope(node, todo.scope)
    arguments = [*node.args.posonlyargs, *node.args.args, *node.args.kwonlyargs, node.args.vararg, node.args.kwarg]
    inner.arguments = frozenset(argument.arg for argument in arguments if argument is not None)
    inner.names = {name: [None] for name in inner.arguments}
    module.scopes[id(node)] = inner
    if todo.cls is not None:
        todo.cls.methods[node.name] = node
        todo.cls.scopes[node.name] = inner
        inner.cls = todo.cls
        static = any(isinstance(each, ast.Name) and each.id == "staticmethod" for each in node.decorator_list)
        positional = [*node.args.posonlyargs, *node.args.args]
        inner.self_name = positional[0].arg if positional and not static else None
    else:
        inner.cls, inner.self_name = todo.scope.cls, todo.scope.self_name
        if inner.self_name in inner.arguments:
            inner.self_name = None
        todo.scope.names.setdefault(node.name, []).append(None)
        if todo.scope is module.scope:
            module.functions.setdefault(node.name, node)
    for outside in (*node.decorator_list, *node.args.defaults, *filter(None, node.args.kw_defaults)):
        yield Todo(outside, todo.scope, None, todo.conditional)
    nested = todo.cls is None and todo.scope is not module.scope
    for statement in node.body:
        yield Todo(statement, inner, None, nested)


def _class(module: Module, todo: Todo, node: ast.ClassDef) -> Iterator[Todo]:
    found = ClassScope(node, todo.scope)
    module.all_classes.append(found)
    module.classes[node.name] = None if node.name in module.classes else found
    if todo.cls is None:
        todo.scope.names.setdefault(node.name, []).append(None)
    for outside in (*node.bases, *node.keywords, *node.decorator_list):
        yield Todo(outside, todo.scope, None, todo.conditional)
    for statement in node.body:
        yield Todo(statement, todo.scope, found, todo.conditional)


def _bind_value(module: Module, todo: Todo, node: ast.Assign | ast.AnnAssign, kept: Kept) -> None:
    if node.value is None:
        return
    targets = node.targets if isinstance(node, ast.Assign) else [node.target]
    for target in targets:
        _assign(todo, target, node.value)
    _keep(kept, node.value, targets[0])


def _bind_target(
    module: Module, todo: Todo, node: ast.AugAssign | ast.For | ast.AsyncFor | ast.NamedExpr, kept: Kept
) -> None:
    _assign(todo, node.target, None)


def _bind_with(module: Module, todo: Todo, node: ast.With | ast.AsyncWith, kept: Kept) -> None:
    for item in node.items:
        if item.optional_vars is not None:
            _assign(todo, item.optional_vars, None)


def _bind_deleted(module: Module, todo: Todo, node: ast.Delete, kept: Kept) -> None:
    for target in node.targets:
        _assign(todo, target, None)


def _bind_exception(module: Module, todo: Todo, node: ast.ExceptHandler, kept: Kept) -> None:
    if node.name:
        _names(todo).setdefault(node.name, []).append(None)


def _bind_global(module: Module, todo: Todo, node: ast.Global, kept: Kept) -> None:
    for name in node.names:
        module.scope.names.setdefault(name, []).append(None)


def _bind_import(module: Module, todo: Todo, node: ast.Import, kept: Kept) -> None:
    for alias in node.names:
        name = alias.asname or alias.name.partition(".")[0]
        _import(module, name, alias.name if alias.asname else name)


def _bind_import_from(module: Module, todo: Todo, node: ast.ImportFrom, kept: Kept) -> None:
    prefix = "." * node.level + (node.module or "")
    for alias in node.names:
        if alias.name == "*":
            module.stars.append(prefix)
            continue
        dotted = f"{prefix}{alias.name}" if prefix.endswith(".") else f"{prefix}.{alias.name}"
        _import(module, alias.asname or alias.name, dotted)


_BINDERS: dict[type[ast.AST], Callable[[Module, Todo, Any, Kept], None]] = {
    ast.Assign: _bind_value,
    ast.AnnAssign: _bind_value,
    **dict.fromkeys((ast.AugAssign, ast.For, ast.AsyncFor, ast.NamedExpr), _bind_target),
    **dict.fromkeys((ast.With, ast.AsyncWith), _bind_with),
    ast.ExceptHandler: _bind_exception,
    ast.Import: _bind_import,
    ast.ImportFrom: _bind_import_from,
    ast.Global: _bind_global,
    ast.Delete: _bind_deleted,
}
"""What binds names, by the type of the statement or expression."""


def _keep(kept: Kept, value: ast.expr, target: ast.expr) -> None:
    if isinstance(value, ast.Await):
        value = value.value
    kept[id(value)] = target


def _import(module: Module, name: str, dotted: str) -> None:
    module.imports[name] = dotted if module.imports.get(name, dotted) == dotted else None


def _names(todo: Todo) -> dict[str, list[ast.expr | None]]:
    return todo.cls.constants if todo.cls is not None else todo.scope.names


def _assign(todo: Todo, target: ast.expr, value: ast.expr | None) -> None:
    if isinstance(target, ast.Name):
        _names(todo).setdefault(target.id, []).append(value)
    elif isinstance(target, (ast.Tuple, ast.List)):
        for element in target.elts:
            _assign(todo, element, None)
    elif isinstance(target, ast.Starred):
        _assign(todo, target.value, None)
    elif isinstance(target, ast.Attribute):
        _assign_attribute(todo, target, value)


def _assign_attribute(todo: Todo, target: ast.Attribute, value: ast.expr | None) -> None:
    owner, scope = target.value, todo.scope
    if isinstance(owner, ast.Name):
        if scope.cls is not None and owner.id == scope.self_name:
            scope.cls.attributes.setdefault(target.attr, []).append((value, scope))
        elif value is not None:
            home = scope.binding(owner.id) or scope
            home.sets.setdefault(owner.id, []).append(AttributeSet(target.attr, value, scope, todo.conditional))
    elif (
        isinstance(owner, ast.Attribute)
        and isinstance(owner.value, ast.Name)
        and scope.cls is not None
        and owner.value.id == scope.self_name
        and value is not None
    ):
        sets = scope.cls.sets.setdefault(owner.attr, [])
        sets.append(AttributeSet(target.attr, value, scope, todo.conditional))


_LEAVES = (ast.Name, ast.Constant, ast.alias)


def _children(module: Module, todo: Todo) -> Iterator[Todo]:
    """What is inside a statement or expression; parts that need not run are conditional."""
    node = todo.node
    if isinstance(node, ast.If) and todo.scope is module.scope and _is_main_guard(node.test):
        module.main = _called(node.body)
        for statement in node.body:
            yield todo._replace(node=statement)
        return
    for name in fields_of(node):
        value = getattr(node, name, None)
        conditional = todo.conditional or _may_not_run(node, name)
        for child in value if isinstance(value, list) else (value,):
            if isinstance(child, ast.AST) and not isinstance(child, _LEAVES):
                yield Todo(child, todo.scope, todo.cls, conditional)


def _may_not_run(node: ast.AST, name: str) -> bool:
    if isinstance(node, (ast.If, ast.For, ast.AsyncFor, ast.While, ast.IfExp, ast.match_case)):
        return name in ("body", "orelse")
    return (isinstance(node, ast.Try) and name == "handlers") or isinstance(node, (ast.Lambda, ast.comprehension))


def _is_main_guard(test: ast.expr) -> bool:
    return (
        isinstance(test, ast.Compare)
        and isinstance(test.left, ast.Name)
        and test.left.id == "__name__"
        and len(test.ops) == 1
        and isinstance(test.ops[0], ast.Eq)
    )


def _called(body: list[ast.stmt]) -> str | None:
    """The one function of the module that a main block calls, when it does nothing else of interest."""
    names = []
    for statement in body:
        for node in ast.walk(statement):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                names.append(node.func.id)
    named = [name for name in names if "main" in name.lower()] or names
    return named[0] if named else ""


def _link_bases(module: Module) -> None:
    for each in module.all_classes:
        for base in each.node.bases:
            if isinstance(base, ast.Name) and module.classes.get(base.id) not in (None, each):
                each.base = module.classes[base.id]
                break
