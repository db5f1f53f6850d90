"""Shell text as far as a linter needs it: simple commands in order."""

from __future__ import annotations

from dataclasses import dataclass

from bringup_lint.source import Located


@dataclass(frozen=True, slots=True)
class Command:
    """One simple command of a shell script or of ``sh -c`` text."""

    words: tuple[Located, ...]
    """The words behind the assignments, quotes removed, nothing expanded."""
    assignments: tuple[Located, ...] = ()
    """``NAME=value`` words before the command; alone they set shell variables."""
    ends: str = ""
    """What ends it: ``;``, ``&&``, ``||``, ``|``, ``&``, a newline, or nothing."""
    depth: int = 0
    """How many compound commands (if, while, functions, subshells) it stands in."""

    @property
    def name(self) -> str:
        """The last component of the program's path; empty for bare assignments."""
        return self.words[0].rpartition("/")[2] if self.words else ""

    @property
    def background(self) -> bool:
        return self.ends == "&"


@dataclass(frozen=True, slots=True)
class Block:
    """A stretch of a script with its structure kept."""

    kind: str
    """``command``, ``for``, ``loop`` (while, until), ``branches`` (if, case), ``group`` ({} and subshells),
    ``function``."""
    command: Command | None = None
    name: str = ""
    """The variable of a ``for``, the name of a ``function``."""
    items: tuple[Located, ...] = ()
    """The words that a ``for`` goes through; for ``for ((...))`` the one arithmetic text."""
    condition: tuple[Block, ...] = ()
    bodies: tuple[tuple[Block, ...], ...] = ()
    """The body; for ``branches`` every branch."""
    arrays: tuple[tuple[str, int], ...] = ()
    """Arrays that a command assigns: name and number of words."""
    arithmetic: str = ""
    """The text of ``((...))``."""
