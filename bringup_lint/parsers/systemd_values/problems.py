"""What is wrong with a value, where, and what systemd does about it."""

from __future__ import annotations

from typing import NamedTuple

from bringup_lint.source import Located

LINE = "line"
"""The assignment is ignored: the earlier value or the default applies."""
WORD = "word"
"""One word of a list is ignored, the rest applies."""
UNIT = "unit"
"""The unit does not load."""
NOTHING = "nothing"
"""The value is taken as it stands, with a message in the log."""


class ValueProblem(NamedTuple):
    code: str
    """``invalid``, ``out-of-range``, ``not-absolute``, ``not-relative``, ``not-normalized``, ``bad-unit-name``,
    ``unknown-specifier``, ``specifier-too-new``, ``too-new``, ``unbalanced-quotes``, ``unknown-escape``,
    ``empty-command``, ``bad-program`` or ``odd-name``."""
    where: Located
    expected: str = ""
    """What may stand here: ``a size such as 512M or 2G``."""
    effect: str = LINE
    suggestion: str | None = None
    """The text that belongs in place of ``where``."""
    safe: bool = False
    """Whether the suggestion is certainly what was meant."""
    since: int = 0
    """The first release that knows the word or specifier, for the codes that end in ``too-new``."""
