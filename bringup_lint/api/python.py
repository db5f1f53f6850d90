"""Changes of Python files that edits cannot express, for ``fix(title, codemod=...)``."""

from __future__ import annotations

from bringup_lint.codemods.lists import move_after
from bringup_lint.codemods.lists import move_before
from bringup_lint.codemods.lists import remove

__all__ = ["move_after", "move_before", "remove"]
