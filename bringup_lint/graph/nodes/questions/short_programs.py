"""Programs that a callback may wait for: they end at once, or end everything."""

from __future__ import annotations

import ast

from bringup_lint.graph.nodes.sources.ending import Ending

_SHORT = frozenset(
    "clear cls reset tput stty echo true false date mkdir touch rm ln cp mv chmod chown kill killall pkill sync "
    "reboot poweroff halt shutdown amixer notify-send".split()
)
_SYSTEMCTL_AT_ONCE = frozenset({"reboot", "poweroff", "halt", "suspend", "kexec", "kill", "is-active", "is-enabled"})


def is_short(ending: Ending, call: ast.Call) -> bool:
    """Whether the first argument of ``os.system`` or ``subprocess.run`` names a program that returns at once."""
    words = _words(ending, call)
    if not words:
        return False
    while words[0] == "sudo" and len(words) > 1:
        words = words[1:]
    program = words[0].rpartition("/")[2]
    if program == "systemctl":
        return "--no-block" in words or not _SYSTEMCTL_AT_ONCE.isdisjoint(words)
    return program in _SHORT or words[-1].endswith("&")


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
    return text.split() if isinstance(text, str) else []
