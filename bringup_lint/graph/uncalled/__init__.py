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
    r"main$|__\w+__$|on_\w+$|(?:do|visit|test|handle|pytest|cmd|lambda)_\w+$|destroy_node$|run$|setup$|update$|initialise$"
    r"|terminate$|execute$|generate_\w+_description$|[a-z]+[A-Z]\w*$"
)
"""Functions that a framework calls by their names; those of Qt are in mixed case."""


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
        if _RUN_BY_OTHERS.match(each.name) or module.is_reflected or self._code.reaches_by_name:
            return False
        cls = module.class_of(each)
        if cls is not None and (not self._code.has_known_bases(cls) or self._code.is_loaded(cls)):
            return False
        mentions = self._code.mentions(each.name, module)
        is_alone = cls is not None and self._code.has_plain_bases(cls)
        return mentions is not None and all(
            (other is module and each.lineno <= use.lineno <= (each.end_lineno or 0))
            or (is_alone and other.has_its_own(use) and not (other is module and cls in module.around(use.lineno)))
            or (depth > 0 and self._is_dead(other, use.lineno, depth - 1))
            for other, use in mentions
        )
