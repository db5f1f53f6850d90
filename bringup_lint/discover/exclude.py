"""Which paths a run leaves out."""

from __future__ import annotations

import os
from collections.abc import Callable
from collections.abc import Sequence
from pathlib import Path


def exclusion(folder: Path | str, patterns: Sequence[str]) -> Callable[[str], bool]:
    """A test for paths (folders end in ``/``): does one of the gitignore patterns, relative to ``folder``, match?"""
    if not patterns:
        return lambda path: False
    from bringup_lint.discover.gitignore import Patterns

    rules = Patterns.of(patterns)

    def excluded(path: str) -> bool:
        relative = os.path.relpath(path, folder)
        return not relative.startswith("..") and rules.match(relative + "/" * path.endswith("/"))

    return excluded
