"""Shell scripts."""

from __future__ import annotations

from bringup_lint.parsers.shell import shell_commands

__all__ = [
    "shell_commands",
]
