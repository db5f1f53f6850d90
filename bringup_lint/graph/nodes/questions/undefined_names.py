"""Names that a node source uses and nothing binds."""

from __future__ import annotations

import ast
import builtins
import sys
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.facts import table
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

_DYNAMIC = regex(
    r"\b(?:exec|eval|globals|locals|__import__|importlib|builtins)\b|\bvars\(",
    hints="exec eval globals locals __import__ importlib builtins vars(",
)
_OF_MODULES = frozenset({"__file__", "__path__", "__class__", "__module__", "__qualname__", "__annotations__", "_"})
"""Names that no statement binds; ``_`` is that of gettext.install()."""
_DEPTH = 3
"""Functions in a row that nothing else mentions."""
_CAUGHT = frozenset({"NameError", "Exception", "BaseException"})
_BINDING_NOTHING = frozenset((ast.Attribute, ast.Call, ast.Constant, ast.Expr, ast.keyword, ast.Assign))
"""The most frequent syntax that binds no name by itself."""
_UNFINISHED = regex(r"(?i)not implemented|do not (?:run|use|call)")
_RUN_BY_OTHERS = regex(r"main$|__\w+__$|on_[a-z]+$|destroy_node$|run$|setup$")
"""Functions that are called by name from elsewhere."""


class Undefined(NamedTuple):
    name: ast.Name
    module: str | None
    """What to import it from; empty for a module itself, None when that is not known."""
    function: str | None
    """Where it is used; None: when the file is imported."""
    idle: bool = False
    """The function says before it that it is not implemented, or nothing calls it."""
    caught: bool = False
    """An ``except Exception`` around it catches the NameError."""
    late: bool = False
    """The function spins, or waits for a thread to end, before: the node has done its work."""
    handling: bool = False
    """It is in an ``except``, which runs only after something else has failed."""


def undefined(syntax: Syntax) -> Iterator[Undefined]:
    """The first use of each name that nothing binds where it is looked up."""
    file = syntax.file
    if file.stars or file.source.matches(_DYNAMIC):
        return
    modules = {row["name"]: row["module"] for row in table("ros/names")}
    lazy = any(dotted == "__future__.annotations" for dotted in file.imports.values())
    bindings = _Bindings(syntax)
    seen: set[str] = set()
    names = (node for node in file.nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load))
    for name in sorted(names, key=lambda each: (each.lineno, each.col_offset)):
        if name.id in seen or bindings.has(name) or _is_harmless(syntax, name, lazy) or syntax.is_dead(name):
            continue
        seen.add(name.id)
        module = modules.get(name.id, "" if name.id in sys.stdlib_module_names else None)
        yield Undefined(
            name,
            module,
            _function(syntax, name),
            idle=is_idle(syntax, name),
            caught=syntax.catches(name, _CAUGHT),
            late=is_late(syntax, name),
            handling=any(isinstance(outer, ast.ExceptHandler) for outer, _ in syntax.within(name)),
        )


class _Bindings:
    """What the scopes of one file bind; a function counts with all that is in it."""

    def __init__(self, syntax: Syntax) -> None:
        self.syntax = syntax
        self._inner: dict[ast.AST, frozenset[str]] = {}
        body = syntax.file.tree.body if syntax.file.tree is not None else []
        outside = set(_all_bound(own(body)))
        declared = {name for node in syntax.file.nodes if isinstance(node, ast.Global) for name in node.names}
        self._module = outside | declared | _OF_MODULES

    def has(self, name: ast.Name) -> bool:
        if name.id in self._module or hasattr(builtins, name.id):
            return True
        in_function = False
        for outer, field in self.syntax.above(name):
            if isinstance(outer, ast.ClassDef):
                if not in_function and field == "body" and name.id in self._of_class(outer):
                    return True
            elif isinstance(outer, _COMPREHENSIONS) or (isinstance(outer, FUNCTIONS) and field == "body"):
                in_function = in_function or isinstance(outer, FUNCTIONS)
                if name.id in self._of(outer):
                    return True
        return False

    def _of(self, outer: ast.AST) -> frozenset[str]:
        if outer not in self._inner:
            self._inner[outer] = frozenset(_all_bound(walk(outer)))
        return self._inner[outer]

    def _of_class(self, outer: ast.ClassDef) -> frozenset[str]:
        if outer not in self._inner:
            self._inner[outer] = frozenset(_all_bound(own(outer.body)))
        return self._inner[outer]


_COMPREHENSIONS = (ast.ListComp, ast.SetComp, ast.DictComp, ast.GeneratorExp)


def is_late(syntax: Syntax, name: ast.expr) -> bool:
    """Whether the function spins, or waits for the end of a thread, before: the node has done its work."""
    function = syntax.function(name)
    before = (call for call in syntax.calls if call.lineno < name.lineno)
    ends = (call for call in before if _waits_for_the_end(call))
    return function is not None and any(syntax.function(call) is function for call in ends)


def _waits_for_the_end(call: ast.Call) -> bool:
    """``join`` of a thread takes nothing, that of a text does."""
    attribute = call.func.attr if isinstance(call.func, ast.Attribute) else ""
    return attribute == "spin" or (attribute == "join" and not call.args)


def is_idle(syntax: Syntax, name: ast.expr) -> bool:
    """Whether the function is only a stub, or nothing in its file mentions it but functions that nothing mentions."""
    function = syntax.function(name)
    if function is None:
        return False
    if any(_says_unfinished(each) for each in walk(function) if getattr(each, "lineno", name.lineno) < name.lineno):
        return True
    return _is_unmentioned(syntax, function, _DEPTH)


def _is_unmentioned(syntax: Syntax, function: ast.FunctionDef | ast.AsyncFunctionDef, depth: int) -> bool:
    if _RUN_BY_OTHERS.match(function.name) or function.decorator_list:
        return False
    users = {syntax.function(each) for each in syntax.file.nodes if _mentions(each, function.name)} - {function}
    known = [each for each in users if each is not None and depth]
    return len(known) == len(users) and all(_is_unmentioned(syntax, each, depth - 1) for each in known)


def _mentions(node: ast.AST, function: str) -> bool:
    """Whether a node calls or hands over a function, by itself or as a method of a plain name; a text may name it."""
    if isinstance(node, ast.Name):
        return node.id == function
    if isinstance(node, ast.Attribute):
        return node.attr == function and isinstance(node.value, (ast.Name, ast.Call))
    return isinstance(node, ast.Constant) and node.value == function


def _says_unfinished(node: ast.AST) -> bool:
    if isinstance(node, ast.Name):
        return node.id == "NotImplementedError"
    text = node.value if isinstance(node, ast.Constant) else None
    return isinstance(text, str) and bool(_UNFINISHED.search(text))


def _all_bound(nodes: Iterable[ast.AST]) -> Iterator[str]:
    return (name for node in nodes if type(node) not in _BINDING_NOTHING for name in bound_names(node))


def _is_harmless(syntax: Syntax, node: ast.Name, lazy: bool) -> bool:
    """Whether the name is never looked up, or a NameError is expected."""
    for above, name in syntax.above(node):
        if lazy and name in ("annotation", "returns"):
            return True
        if isinstance(above, ast.Try) and name == "body":
            caught = {each.id for handler in above.handlers for each in _types(handler)}
            if "NameError" in caught or any(handler.type is None for handler in above.handlers):
                return True
        if isinstance(above, ast.AnnAssign) and name == "annotation" and syntax.function(node) is not None:
            return True
    return False


def _types(handler: ast.ExceptHandler) -> Iterator[ast.Name]:
    if handler.type is not None:
        yield from (each for each in ast.walk(handler.type) if isinstance(each, ast.Name))


def _function(syntax: Syntax, node: ast.AST) -> str | None:
    """The function whose call looks the name up; defaults, decorators and annotations are looked up at once."""
    for above, name in syntax.above(node):
        if isinstance(above, FUNCTIONS) and name == "body":
            return getattr(above, "name", "a lambda")
    return None
