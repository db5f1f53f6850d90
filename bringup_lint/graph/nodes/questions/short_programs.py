"""Programs that a callback may wait for: they end at once, or end everything."""

from __future__ import annotations

import ast

from bringup_lint.facts.short_programs import returns_at_once
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.parsers.shell import split


def is_short(ending: Ending, call: ast.Call) -> bool:
    """Whether the first argument of ``os.system`` or ``subprocess.run`` names a program that returns at once."""
    return returns_at_once(_words(ending, call))


def _words(ending: Ending, call: ast.Call) -> list[str]:
    """The literal words of the command; its first words when the later ones are not known."""
    given = call.args[0] if call.args else None
    if isinstance(given, ast.IfExp):
        given = given.body
    if isinstance(given, (ast.List, ast.Tuple)):
        parts = [ending.file.constant(each, ending.syntax.function(call)) for each in given.elts]
        known = [part for part in parts if isinstance(part, str)]
        return known if parts and isinstance(parts[0], str) else []
    text = ending.file.constant(given, ending.syntax.function(call)) if given is not None else None
    return split(text) if isinstance(text, str) else []
