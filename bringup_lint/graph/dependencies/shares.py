"""The packages whose folders are needed whenever a launch file is loaded or a robot description is computed."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.python import walk
from bringup_lint.parsers.python_syntax import Positions
from bringup_lint.parsers.python_syntax import byte_order_mark
from bringup_lint.parsers.python_syntax import tree_of
from bringup_lint.parsers.xml import parse
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.model.xml import Element

_FUNCTIONS = ("get_package_share_directory", "get_package_share_path", "get_package_prefix")
"""What looks a package up while Python builds the description."""
_ENTRIES = ("generate_launch_description", "launch_setup")
_APART = ("xacro:if", "xacro:unless", "gazebo")
"""What is looked at under a condition, or by a simulator alone."""
_FIND = regex(r"\$\(find[ \t]{1,8}([\w-]+)[ \t]{0,8}\)", hints="$(find")


def shares_of_python(source: Source) -> tuple[Located, ...]:
    """The packages that a Python launch file looks up in any case, kept: no ``try`` and no ``if`` surrounds them."""
    return source.once(shares_of_python, lambda: tuple(_of_python(source)))


def _of_python(source: Source) -> Iterator[Located]:
    tree = tree_of(source)
    if tree is None:
        return
    positions = Positions(source, byte_order_mark(source))
    for statement in _statements(tree):
        for node in walk(statement):
            name = _looked_up(node)
            if name is not None:
                yield Located(str(name.value), positions.span(name))


def _statements(tree: ast.Module) -> Iterator[ast.stmt]:
    """The simple statements that run whenever the file is loaded, or its entry function, or a function of the file that
    these name."""
    functions = {each.name: each for each in tree.body if isinstance(each, ast.FunctionDef)}
    entered = [name for name in _ENTRIES if name in functions]
    bodies = [tree.body, *(functions[name].body for name in entered)]
    while bodies:
        for each in bodies.pop(0):
            if isinstance(each, (ast.Assign, ast.AnnAssign, ast.Expr, ast.Return)):
                yield each
                called = {node.id for node in walk(each) if isinstance(node, ast.Name)} & functions.keys()
                bodies += [functions[name].body for name in sorted(called.difference(entered))]
                entered += called


def _looked_up(node: ast.AST) -> ast.Constant | None:
    if not isinstance(node, ast.Call) or len(node.args) != 1:
        return None
    name = node.func.id if isinstance(node.func, ast.Name) else getattr(node.func, "attr", "")
    given = node.args[0]
    is_text = isinstance(given, ast.Constant) and isinstance(given.value, str) and given.value.isidentifier()
    return given if name in _FUNCTIONS and is_text and isinstance(given, ast.Constant) else None


def shares_of_description(source: Source) -> Iterator[Located]:
    """The packages that xacro looks up under no condition of the file."""
    root = parse(source).root
    if root is None:
        return
    for element in _unconditional(root):
        for text in (*(each.value for each in element.attributes), *element.texts):
            for match in _FIND.finditer(text):
                yield text.part(match.start(1), match.end(1))


def _unconditional(root: Element) -> Iterator[Element]:
    pending = [root]
    while pending:
        element = pending.pop()
        if element.name not in _APART:
            yield element
            pending.extend(reversed(element.children))
