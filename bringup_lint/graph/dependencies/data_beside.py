"""Files that Python modules look for beside themselves, and that setuptools leaves in the source."""

from __future__ import annotations

import ast
import os
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from bringup_lint.graph.dependencies.imports import imported
from bringup_lint.graph.dependencies.subpackages import is_installed
from bringup_lint.graph.memo import kept
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Package
    from bringup_lint.model.package import Packages
    from bringup_lint.source import Source
    from bringup_lint.source import Span

_LOOKS = regex(r"__file__|\brender_template\b", hints="__file__ render_template")
_PACKS = regex(
    r"package[_-]data|exclude_package_data|setuptools[_-](?:scm|git)|site-packages|\bcmdclass\b|get_path\(",
    hints="package_data package-data setuptools site-packages cmdclass get_path",
)
"""What may install more than modules, in setup.py, setup.cfg and pyproject.toml."""
_SETTINGS = ("setup.py", "setup.cfg", "pyproject.toml")
_SAME = ("abspath", "realpath", "normpath", "fspath", "Path", "PurePath", "str")
"""Functions that give the path that they are given."""
_DEEPEST = 40
"""Steps in which a path is computed."""
_METHODS = ("resolve", "absolute", "as_posix")
_ASKS = frozenset(
    "exists isfile isdir is_file is_dir glob rglob mkdir makedirs insert append save savefig savetxt savez imwrite"
    " to_csv write_text write_bytes touch".split()
)
"""What asks first whether a file is there or makes it, and what lengthens the path of modules."""

_WORD = regex(r"[A-Za-z_][\w.-]*")
_TESTS = frozenset("exists isfile isdir is_file is_dir".split())
_DEFAULTS = frozenset("declare_parameter add_argument get getenv".split())
"""What gives a value where nobody gives another one, by the name that is its first argument."""
_GIVING = regex(r"(?:launch|\.ya?ml|\.xml|\.sh|\.bash|\.service|\.env|\.conf|[Dd]ockerfile[^/]*|[Mm]akefile)(?:\.py)?$")
"""Files that start nodes and set them up."""


class Beside(NamedTuple):
    where: Span
    path: str
    """From the folder of the package of ROS."""
    installed: Packages
    """What is installed."""


def data_beside(tree: Tree, package: Package) -> Iterator[Beside]:
    """What the console scripts of a package look for, each file or folder at its first use."""
    if package.manifest.build_type != "ament_python" or _packs(tree, package):
        return
    for build in package.builds:
        if build.python_packages is not None:
            found: set[str] = set()
            for source in _modules(tree, package, build.python_packages):
                for where, path in _looked_for(tree, package, source):
                    if path not in found:
                        found.add(path)
                        yield Beside(where, os.path.relpath(path, package.folder), build.python_packages)


def _packs(tree: Tree, package: Package) -> bool:
    paths = (os.path.join(package.folder, name) for name in _SETTINGS)
    return any(_PACKS.search(tree.head(path, 100_000)) for path in paths if tree.is_file(path))


def _modules(tree: Tree, package: Package, listed: Packages) -> Iterator[Source]:
    """The modules that console scripts name, and what these import of the package, and so on."""
    todo = [target.partition(":")[0].strip() for target in package.entry_points.values()]
    seen = set(todo)
    while todo:
        name = todo.pop(0)
        folder = name.rpartition(".")[0]
        source = tree.at(os.path.join(package.folder, *name.split(".")) + ".py")
        if source is None or not folder or not is_installed(tree, package, listed, folder):
            continue
        yield source
        for module in imported(source, folder):
            for each in (str(module), *_members(source, str(module))):
                if each not in seen:
                    seen.add(each)
                    todo.append(each)


def _members(source: Source, module: str) -> Iterator[str]:
    """What ``from package import module`` may mean."""
    tree = tree_of(source)
    if tree is None:
        return
    for statement in tree.body:
        if isinstance(statement, ast.ImportFrom) and (statement.level or statement.module == module):
            yield from (f"{module}.{alias.name}" for alias in statement.names)


def _looked_for(tree: Tree, package: Package, source: Source) -> Iterator[tuple[Span, str]]:
    """The files and folders of the package that a module names by its own place, with absolute paths."""
    syntax = tree_of(source) if _LOOKS.search(source.text) else None
    if syntax is None:
        return
    paths = _Paths(source, syntax)
    positions = Positions(source, byte_order_mark(source))
    named = {path: node for node in reversed(paths.outermost) if (path := paths.value(node)) is not None}
    ordered = sorted(f"{path}/" for path in named)
    parts = {path[:-1] for path, other in pairwise(ordered) if other.startswith(path)}
    for path, node in sorted(named.items(), key=lambda item: item[1].lineno):
        if path in parts or path in paths.asked or not _given(tree).isdisjoint(paths.defaults.get(path, ())):
            continue
        if _is_data(tree, package, source, path):
            yield positions.span(node), path


def _is_data(tree: Tree, package: Package, source: Source, path: str) -> bool:
    """Whether a path is that of a file, or of a folder without modules, of the package."""
    if not path.startswith(f"{package.folder}/") or source.absolute.startswith(f"{path}/") or path.endswith(".py"):
        return False
    if tree.is_file(path):
        return True
    below = list(tree.walked_below(path))
    return bool(below) and not any(each.endswith(".py") for each in below)


@kept
def _given(tree: Tree) -> frozenset[str]:
    """The words of files that start nodes or set them up, parameters, options and variables among them."""
    return frozenset(word for text in tree.pages(_GIVING, 100_000) for word in _WORD.findall(text))


class _Paths:
    """The paths that a module computes from its own place."""

    def __init__(self, source: Source, syntax: ast.Module) -> None:
        self._file = source.absolute
        self._variables: dict[str, str] = {}
        self.outermost: list[ast.expr] = []
        """The expressions that may be such paths, no parts of others, in any order."""
        self.asked: set[str] = set()
        """The paths of which the module asks whether they are there, or that it makes."""
        self.defaults: dict[str, list[str]] = {}
        """The names of parameters, options and variables of which a path is the default."""
        self._flask = _has_flask(syntax)
        nodes = list(_run_when_imported(syntax))
        for node in nodes:
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], (ast.Name, ast.Attribute)):
                value = self.value(node.value)
                name = _dotted(node.targets[0])
                if value is not None and name:
                    self._variables[name] = value
        self._collect(nodes)
        self._excuse(syntax, nodes)

    def _collect(self, nodes: list[ast.AST]) -> None:
        parts: set[int] = set()
        for node in nodes:
            if not isinstance(node, (ast.Call, ast.BinOp, ast.JoinedStr)):
                continue
            if isinstance(node, ast.Call) and (_name(node.func) in _ASKS or _writes(node)):
                given = [*node.args, *([node.func.value] if isinstance(node.func, ast.Attribute) else [])]
                self.asked.update(path for each in given if (path := self.value(each)) is not None)
            if id(node) in parts:
                parts.update(map(id, ast.iter_child_nodes(node)))
            elif self.value(node) is not None:
                self.outermost.append(node)
                parts.update(map(id, ast.walk(node)))

    def _excuse(self, syntax: ast.Module, nodes: list[ast.AST]) -> None:
        """Adds what one of several places, or a function of the module, may test before, and what nothing reads, but
        for the constants of the module, which others may import."""
        names = (each for each in ast.walk(syntax) if isinstance(each, ast.Name))
        read = {each.id for each in names if isinstance(each.ctx, ast.Load)}
        constants = set(map(id, syntax.body))
        has_test = any(isinstance(each, ast.Call) and _name(each.func) in _TESTS for each in nodes)
        own = {each.name for each in nodes if isinstance(each, ast.FunctionDef)} if has_test else set()
        for node in nodes:
            tested: list[ast.expr] = []
            if isinstance(node, (ast.List, ast.Tuple)) and has_test:
                tested = node.elts
            elif isinstance(node, ast.Assign) and id(node) not in constants:
                is_read = any(not isinstance(each, ast.Name) or each.id in read for each in node.targets)
                tested = [] if is_read else [node.value]
            elif isinstance(node, ast.Call):
                tested = node.args if _name(node.func) in own else []
                self._note_default(node)
            self.asked.update(path for each in tested if (path := self.value(each)) is not None)

    def _note_default(self, call: ast.Call) -> None:
        name = self._text(call.args[0]) if call.args and _name(call.func) in _DEFAULTS else None
        if name is None:
            return
        for each in (*call.args[1:], *(each.value for each in call.keywords)):
            path = self.value(each)
            if path is not None:
                self.defaults.setdefault(path, []).append(name.lstrip("-"))

    def value(self, node: ast.expr, depth: int = 0) -> str | None:
        """An absolute path; None of everything else."""
        inner = depth + 1
        if inner > _DEEPEST:
            return None
        if isinstance(node, (ast.Name, ast.Attribute)):
            if isinstance(node, ast.Name) and node.id == "__file__":
                return self._file
            known = self._variables.get(_dotted(node))
            above = self.value(node.value, inner) if isinstance(node, ast.Attribute) and node.attr == "parent" else None
            return os.path.dirname(above) if above is not None else known
        if isinstance(node, ast.Subscript):
            return self._above(node, inner)
        if isinstance(node, ast.BinOp):
            return self._joined(node.op, self.value(node.left, inner), self._text(node.right))
        if isinstance(node, ast.JoinedStr):
            return self._format(node, inner)
        return self._called(node, inner) if isinstance(node, ast.Call) else None

    def _above(self, node: ast.Subscript, depth: int) -> str | None:
        """``Path(...).parents[1]``."""
        number = node.slice.value if isinstance(node.slice, ast.Constant) else None
        is_parents = isinstance(node.value, ast.Attribute) and node.value.attr == "parents"
        path = self.value(node.value.value, depth) if isinstance(node.value, ast.Attribute) and is_parents else None
        if path is None or not isinstance(number, int) or number >= path.count("/"):
            return None
        for _ in range(number + 1):
            path = os.path.dirname(path)
        return path

    @staticmethod
    def _joined(operator: ast.operator, path: str | None, more: str | None) -> str | None:
        if path is None or more is None:
            return None
        if isinstance(operator, ast.Div):
            return os.path.normpath(os.path.join(path, more))
        return os.path.normpath(path + more) if isinstance(operator, ast.Add) else None

    def _format(self, node: ast.JoinedStr, depth: int) -> str | None:
        first, *others = node.values or [node]
        path = self.value(first.value, depth) if isinstance(first, ast.FormattedValue) else None
        texts = [str(each.value) for each in others if isinstance(each, ast.Constant)]
        return os.path.normpath(path + "".join(texts)) if path is not None and len(texts) == len(others) else None

    def _called(self, node: ast.Call, depth: int) -> str | None:
        name = _name(node.func)
        if name == "render_template" and self._flask and node.args:
            template = self._text(node.args[0])
            return template and os.path.join(os.path.dirname(self._file), "templates", template)
        if name in _METHODS and isinstance(node.func, ast.Attribute):
            return self.value(node.func.value, depth)
        parts = [*node.args]
        if name == "joinpath" and isinstance(node.func, ast.Attribute):
            parts.insert(0, node.func.value)
        path = self.value(parts[0], depth) if parts else None
        if path is None or (name in _SAME and len(parts) == 1):
            return path
        if name == "dirname":
            return os.path.dirname(path)
        more = [self._text(each) for each in parts[1:]]
        known = [each for each in more if each is not None]
        is_path = name in ("join", "joinpath", *_SAME) and len(known) == len(more)
        return os.path.normpath(os.path.join(path, *known)) if is_path else None

    @staticmethod
    def _text(node: ast.expr) -> str | None:
        if isinstance(node, ast.Attribute) and node.attr == "pardir":
            return ".."
        return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _dotted(node: ast.AST) -> str:
    """A name, or that of an attribute of one; empty for everything else."""
    if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
        return f"{node.value.id}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else ""


def _name(function: ast.expr) -> str:
    return function.id if isinstance(function, ast.Name) else getattr(function, "attr", "")


def _writes(call: ast.Call) -> bool:
    """Whether a file is opened for more than to read it."""
    modes = [*call.args[1:2], *(each.value for each in call.keywords if each.arg == "mode")]
    given = "".join(str(each.value) for each in modes if isinstance(each, ast.Constant))
    return _name(call.func) == "open" and not set("wax").isdisjoint(given)


def _has_flask(syntax: ast.Module) -> bool:
    """Whether a module makes a web server that looks for its templates beside it."""
    return any(
        isinstance(node, ast.Call)
        and _name(node.func) == "Flask"
        and {each.arg for each in node.keywords}.isdisjoint(("template_folder", "root_path", None))
        for node in ast.walk(syntax)
    )


def _run_when_imported(syntax: ast.Module) -> Iterator[ast.AST]:
    """All nodes in the order of the text, outer ones first, but for ``try`` and what runs only as a script."""
    todo: list[ast.AST] = [syntax]
    while todo:
        node = todo.pop()
        is_main = isinstance(node, ast.If) and any(_dotted(each) == "__name__" for each in ast.walk(node.test))
        if not is_main and not (isinstance(node, ast.Try) and node.handlers):
            yield node
            todo.extend(reversed(list(ast.iter_child_nodes(node))))
