"""What the models of Python files share."""

from __future__ import annotations

import ast
import warnings
from typing import Union

PlacedNode = Union["ast.expr", "ast.stmt", "ast.keyword", "ast.arg", "ast.excepthandler", "ast.alias"]
"""The nodes of a syntax tree that have a place in the text; those of operators, contexts and clauses have none."""


def syntax_of(text: str) -> ast.Module | None:
    """The tree of a text, without the warnings of Python about it; None when it is not Python."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
