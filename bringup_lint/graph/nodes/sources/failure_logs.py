"""Which calls of a Python node log a failure."""

from __future__ import annotations

import ast

from bringup_lint.model.python import last_name
from bringup_lint.model.python import walk

_LOGS = frozenset({"error", "fatal", "critical"})


def is_failure_log(call: ast.Call) -> bool:
    if not isinstance(call.func, ast.Attribute) or call.func.attr not in _LOGS:
        return False
    return any("logger" in last_name(each) for each in walk(call.func.value))
