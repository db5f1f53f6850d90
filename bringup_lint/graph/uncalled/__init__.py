"""Python code of a tree that never runs: functions that nothing calls, hands over or names, and branches whose
condition is the same constant everywhere. What is found there is information.

Only what is plain counts: fragments of which the tree holds no program, a method that an unknown base may call, a name
that a text holds or that is put together, a decorator, and code that cannot be read all may run it."""

from __future__ import annotations

import ast

from bringup_lint.graph.files import Files
from bringup_lint.graph.memo import memo
from bringup_lint.graph.uncalled.branches import Branches
from bringup_lint.graph.uncalled.code import Code
from bringup_lint.graph.uncalled.module import Function
from bringup_lint.graph.uncalled.module import Module
from bringup_lint.graph.uncalled.module import has_plain_decorators
from bringup_lint.pattern import regex
from bringup_lint.source import Span

_DEPTH = 3
"""Functions in a row that only the next one calls."""
_RUN_BY_OTHERS = regex(
    r"main$|__\w+__$|(?:do|visit|test|handle|pytest|cmd|lambda)_\w+$|destroy_node$|run$|setup$|update$|initialise$"
    r"|terminate$|execute$|generate_\w+_description$|[a-z]+[A-Z]\w*$"
)
"""Functions that a framework calls by their names; those of Qt are in mixed case."""
_EVENT = regex(r"on_\w+$")
"""The same, but of plain nodes, whose callbacks are handed over."""


class Uncalled:
    """Asked for a place: whether it is in code that never runs."""

    def __init__(self, files: Files) -> None:
        self._files = files
        self._code = Code(files)
        self._branches = Branches(self._code)

    def has(self, place: Span) -> bool:
        source = place.source
        if source.origin is not None or not self._code.is_python(source) or self._files.is_configured(source):
            return False
        module = self._code.module_of(source)
        return module is not None and self._code.has_programs and self._is_dead(module, place.line, _DEPTH)

    def _is_dead(self, module: Module, line: int, depth: int) -> bool:
        """Whether a line is in a function that nothing uses, or in a branch that is never taken. What is on its first
        line is about the function itself."""
        for each in module.around(line):
            if isinstance(each, ast.If):
                if self._branches.skip(module, each, line):
                    return True
            elif not isinstance(each, ast.ClassDef) and line > each.lineno and self._is_unused((module, each, depth)):
                return True
        return False

    @memo
    def _is_unused(self, asked: tuple[Module, Function, int]) -> bool:
        module, each, depth = asked
        if not has_plain_decorators(each):
            return False
        if _RUN_BY_OTHERS.match(each.name) or module.is_reflected or self._may_be_reached(each.name):
            return False
        cls = module.class_of(each)
        if _EVENT.match(each.name) and (cls is None or not self._code.is_node(cls)):
            return False
        if cls is not None and (not self._code.has_known_bases(cls) or self._code.is_loaded(cls)):
            return False
        mentions = self._code.mentions(each.name, module)
        return mentions is not None and all(
            (other is module and each.lineno <= use.lineno <= (each.end_lineno or 0))
            or (cls is not None and self._is_of_another(cls, other, use))
            or (depth > 0 and self._is_dead(other, use.lineno, depth - 1))
            for other, use in mentions
        )

    def _may_be_reached(self, name: str) -> bool:
        """Whether other files may call a function by a name that they compute: hardly one that is not for them."""
        return not name.startswith("_") and self._code.reaches_by_name

    def _is_of_another(self, cls: ast.ClassDef, other: Module, use: ast.expr) -> bool:
        """Whether a name that a method of a class has is another thing: a method of its own of a class that this one
        does not build on, or a variable, as the body of a class alone has its methods as such."""
        if isinstance(use, ast.Name):
            return other.has_variable(use)
        owner = other.owner(use)
        return owner is not None and owner is not cls and owner.name not in self._code.ancestors(cls)
