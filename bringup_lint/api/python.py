"""Changes of Python files that edits cannot express, for ``fix(title, codemod=...)``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.codemods.calls import all_of
    from bringup_lint.codemods.calls import in_call
    from bringup_lint.codemods.calls import in_list
    from bringup_lint.codemods.calls import renamed_keyword
    from bringup_lint.codemods.calls import with_item
    from bringup_lint.codemods.calls import with_items
    from bringup_lint.codemods.calls import with_keyword
    from bringup_lint.codemods.calls import without_keyword
    from bringup_lint.codemods.imports import Import
    from bringup_lint.codemods.lists import move_after
    from bringup_lint.codemods.lists import move_before
    from bringup_lint.codemods.lists import remove
    from bringup_lint.codemods.statements import wait_in_loop
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Import",
    "all_of",
    "in_call",
    "in_list",
    "move_after",
    "move_before",
    "remove",
    "renamed_keyword",
    "wait_in_loop",
    "with_item",
    "with_items",
    "with_keyword",
    "without_keyword",
]
