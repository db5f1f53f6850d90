"""The commands of RUN, PROGRAM and IMPORT{program}, split into words as udev does: quotes, no shell."""

from __future__ import annotations

from functools import cache

from bringup_lint import facts
from bringup_lint.dataclass import dataclass
from bringup_lint.model.udev import Token
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_WORD = regex(r"(?:[^\s'\"]+|'[^']*(?:'|\Z)|\"[^\"]*(?:\"|\Z))+")
_OPERATOR = regex(r"&&|\|\|?|;|&|[0-9]?>>?(?:&[0-9])?(?:/\S*)?|<")
_SHELLS = frozenset({"sh", "bash", "dash", "ash", "zsh", "busybox", "su", "runuser", "sudo"})


@dataclass(frozen=True)
class Command:
    """One command line of a rule."""

    token: Token
    words: tuple[Located, ...]
    """With their quotes."""

    @property
    def program(self) -> Located:
        return self.words[0]

    @property
    def name(self) -> str:
        return self.program.rpartition("/")[2]

    @property
    def is_looked_up_in_vain(self) -> bool:
        """Whether it is a well-known command of the system, which udev looks up in /usr/lib/udev only."""
        return "/" not in self.program and self.program in _system_commands()

    @property
    def runs_shell(self) -> bool:
        return any(word.strip("'\"").rpartition("/")[2] in _SHELLS for word in self.words)

    @property
    def shell_operators(self) -> list[Located]:
        """Words that only a shell would understand, when no shell reads them."""
        if self.runs_shell:
            return []
        found = [word for word in self.words[1:] if _OPERATOR.fullmatch(word)]
        return found or [word.part(len(word) - 1, len(word)) for word in self.words[:-1] if word.endswith(";")]

    @property
    def text(self) -> Located:
        return self.token.value


def read_command(token: Token) -> Command:
    """The words of a command; one empty word when there is none."""
    words = tuple(token.value.part(*found.span()) for found in _WORD.finditer(token.value))
    return Command(token, words or (token.value,))


@cache
def _system_commands() -> frozenset[str]:
    return frozenset(row["name"] for row in facts.table("host/system_commands"))
