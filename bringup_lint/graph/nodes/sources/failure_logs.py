"""Which calls of a Python node log something, such as a failure."""

from __future__ import annotations

import ast

from bringup_lint.model.python import last_name
from bringup_lint.model.python import walk

_LOGS = frozenset({"error", "fatal", "critical"})
_LEVELS = _LOGS | {"exception", "warning", "warn", "info"}
"""What is shown where nobody asks for more."""


def is_failure_log(call: ast.Call) -> bool:
    return _is_logged(call, _LOGS)


def is_said(call: ast.Call) -> bool:
    """Whether a call prints, or logs at a level that is shown."""
    return last_name(call.func) in ("print", "print_exc") or _is_logged(call, _LEVELS)


def _is_logged(call: ast.Call, levels: frozenset[str]) -> bool:
    if not isinstance(call.func, ast.Attribute) or call.func.attr not in levels:
        return False
    return any("logg" in last_name(each) for each in walk(call.func.value))
