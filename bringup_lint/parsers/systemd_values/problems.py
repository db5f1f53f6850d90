"""What is wrong with a value, where, and what systemd does about it."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.source import Located
from bringup_lint.source import Problem

LINE = "line"
"""The assignment is ignored: the earlier value or the default applies."""
WORD = "word"
"""One word of a list is ignored, the rest applies."""
UNIT = "unit"
"""The unit does not load."""
NOTHING = "nothing"
"""The value is taken as it is, with a message in the log."""


@dataclass(frozen=True, slots=True)
class ValueProblem(Problem):
    """The codes are ``invalid``, ``out-of-range``, ``not-absolute``, ``not-relative``, ``not-normalized``,
    ``bad-unit-name``, ``unknown-specifier``, ``specifier-too-new``, ``too-new``, ``unbalanced-quotes``,
    ``unknown-escape``, ``empty-command``, ``bad-program`` or ``odd-name``. The detail is what is expected, such as
    ``a size such as 512M or 2G``."""

    where: Located
    effect: str = LINE
    suggestion: str | None = None
    """The text that belongs in place of ``where``."""
    safe: bool = False
    """Whether the suggestion is certainly what was meant."""
    since: int = 0
    """The first release that knows the word or specifier, for the codes that end in ``too-new``."""

    @property
    def expected(self) -> str:
        """What may be written here."""
        return self.detail
