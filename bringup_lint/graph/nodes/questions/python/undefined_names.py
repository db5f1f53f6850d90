"""Names that a node source uses and nothing binds."""

from __future__ import annotations

import ast
import builtins
import sys
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.graph.nodes.sources.idle import is_idle
from bringup_lint.graph.nodes.sources.idle import is_late
from bringup_lint.graph.nodes.sources.syntax import COMPREHENSIONS
from bringup_lint.graph.nodes.sources.syntax import FUNCTIONS
from bringup_lint.graph.nodes.sources.syntax import Syntax
from bringup_lint.graph.nodes.sources.syntax import own
from bringup_lint.model.python import bound_names
from bringup_lint.model.python import walk
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_DYNAMIC = regex(
    r"\b(?:exec|eval|globals|locals|__import__|importlib|builtins)\b|\bvars\(",
    hints="exec eval globals locals __import__ importlib builtins vars(",
)
_GIVES_NAMES = frozenset("exec eval globals locals __import__ importlib builtins vars".split())
_OF_MODULES = frozenset(
    ("__file__", "__path__", "__class__", "__module__", "__qualname__", "__annotations__", "_", "WindowsError")
)
"""Names that no statement binds: ``_`` is that of gettext.install(), and one is looked up on Windows alone."""
_OF_PYTHON_2 = frozenset(
    ("basestring", "cmp", "execfile", "file", "long", "raw_input", "reduce", "reload", "unichr", "unicode", "xrange")
)
_BOTH_PYTHONS = regex(
    r"\bversion_info\b|\bsys\.version\b|\bPY[23]\b|\bsix\b|\bpython2\b|\bpython_version\b",
    hints="version_info sys.version PY2 PY3 six python2 python_version",
)
_CAUGHT = frozenset({"NameError", "Exception", "BaseException"})


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
    branch: bool = False
    """It is in a branch of its function, which may not run."""


def undefined_in(nodes: Nodes, file: NodeSource) -> list[Undefined]:
    """Those of a source of nodes; of another file none where a program loads it that gives it names, as SCons does,
    and none that it may look up in Python 2 alone."""
    found = list(undefined(nodes.syntax(file)))
    if not found or not nodes.is_plain(file):
        return found
    if any(each.function is None and each.name.id not in _OF_PYTHON_2 for each in found):
        return []
    has_both = file.source.matches(_BOTH_PYTHONS)
    return [each for each in found if each.name.id not in _OF_PYTHON_2 or not (each.branch or has_both)]


def undefined(syntax: Syntax) -> Iterator[Undefined]:
    """The first use of each name that nothing binds where it is looked up."""
    file = syntax.file
    if file.stars or (file.source.matches(_DYNAMIC) and any(map(_gives_names, file.nodes))):
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
            branch=_is_in_branch(syntax, name),
        )


def _gives_names(node: ast.AST) -> bool:
    """Whether a piece of syntax, and no comment or text, mentions what may give the file names."""
    names = [getattr(node, field, None) for field in ("id", "module")]
    names += [node.name] if isinstance(node, ast.alias) else []
    return any(part in _GIVES_NAMES for name in names if isinstance(name, str) for part in name.split("."))


def _is_in_branch(syntax: Syntax, name: ast.Name) -> bool:
    """Whether a condition around a name decides whether a function looks it up."""
    function = syntax.function(name)
    conditions = (outer for outer, field in syntax.within(name) if isinstance(outer, ast.If) and field != "test")
    return function is not None and next(conditions, None) is not None


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
            elif isinstance(outer, COMPREHENSIONS) or (isinstance(outer, FUNCTIONS) and field == "body"):
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


def _all_bound(nodes: Iterable[ast.AST]) -> Iterator[str]:
    return (name for node in nodes for name in bound_names(node))


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
