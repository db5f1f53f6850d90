"""Programs that a callback may wait for: they end at once, or end everything."""

from __future__ import annotations

import ast

from bringup_lint.facts.short_programs import returns_at_once
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.pattern import regex

_OPERATOR = regex(r"(?<![>\d])(\|\|?|&&?|;)")


def is_short(ending: Ending, call: ast.Call) -> bool:
    """Whether the first argument of ``os.system`` or ``subprocess.run`` names a program that returns at once."""
    return returns_at_once(_words(ending, call))


def is_long(ending: Ending, call: ast.Call) -> bool:
    """Whether it surely names a program, and another one."""
    words = _words(ending, call)
    return bool(words) and not returns_at_once(words)


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
    if isinstance(text, str):
        return _tokens(text)
    return _template(ending, given, call)


def _tokens(text: str) -> list[str]:
    """The words of a command line, with the operators between its commands."""
    return _OPERATOR.sub(r" \1 ", text).split()


def _template(ending: Ending, given: ast.expr | None, call: ast.Call) -> list[str]:
    """The words of an f-string, also of one that a name holds, with ``{}`` for what it fills in."""
    if isinstance(given, ast.Name):
        given = _assigned(ending, given.id, call)
    if not isinstance(given, ast.JoinedStr):
        return []
    parts = (each.value if isinstance(each, ast.Constant) else "{}" for each in given.values)
    return _tokens("".join(map(str, parts)))


def _assigned(ending: Ending, name: str, call: ast.Call) -> ast.expr | None:
    """The one value that the function of a call gives to a name."""
    function = ending.syntax.function(call)
    body = ast.walk(function) if function is not None else ()
    found = [each for each in body if isinstance(each, ast.Assign) and _is_name(each.targets, name)]
    return found[0].value if len(found) == 1 else None


def _is_name(targets: list[ast.expr], name: str) -> bool:
    return len(targets) == 1 and isinstance(targets[0], ast.Name) and targets[0].id == name
