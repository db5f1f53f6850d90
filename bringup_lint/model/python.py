"""What the models of Python files share."""

from __future__ import annotations

from typing import TYPE_CHECKING
from typing import Union

if TYPE_CHECKING:
    import ast

PlacedNode = Union["ast.expr", "ast.stmt", "ast.keyword", "ast.arg", "ast.excepthandler", "ast.alias"]
"""The nodes of a syntax tree that have a place in the text; those of operators, contexts and clauses have none."""
