"""The plain text of C++ sources: comments and blocks, where no syntax tree is needed."""

from __future__ import annotations

from bringup_lint.pattern import regex
from bringup_lint.source import Source

COMMENT = regex(r"//[^\n]*|/\*(?:[^*]|\*(?!/))*(?:\*/|\Z)")
_BRACES = regex(r"[{}]")


def blanked(text: str) -> str:
    """A text with blanks for its comments: all offsets stay."""
    return COMMENT.sub(lambda comment: " " * len(comment[0]), text)


def plain_of(source: Source) -> str:
    """The text of a source with blanks for its comments, made once for all that ask."""
    return source.once(plain_of, lambda: blanked(source.text))


def end_of_block(plain: str, start: int) -> int:
    """The offset of the brace that ends a block, in a text without comments.

    ``start`` is behind the brace that begins it; a block without an end goes to the end of the text.
    """
    level = 1
    for brace in _BRACES.finditer(plain, start):
        level += 1 if brace[0] == "{" else -1
        if level == 0:
            return brace.start()
    return len(plain)
