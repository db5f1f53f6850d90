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
