"""Shell text as far as a linter needs it: commands with their words and redirections, and the structure around them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby

from bringup_lint.dataclass import dataclass
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Span


class Word(Located):
    """A word without its quotes, which knows where they were."""

    __slots__ = ("quotes",)

    quotes: tuple[str, ...]
    """For each of the ``pieces`` the quote around it: ``'`` (nothing is expanded), ``"``, or nothing."""

    def __new__(
        cls,
        text: str,
        span: Span,
        pieces: tuple[tuple[int, int], ...] | None = None,
        quotes: tuple[str, ...] = (),
    ) -> Word:
        self = super().__new__(cls, text, span, pieces)
        assert isinstance(self, Word)
        self.quotes = quotes
        return self

    def part(self, start: int, end: int) -> Word:
        """Some of the word, with its quotes."""
        found = super().part(start, end)
        kept = [(max(at, start), quote) for at, to, quote in self._places() if to > start and at < end]
        pieces = tuple((at - start, self.origin(at)) for at, _ in kept)
        return Word(found, found.span, pieces or found.pieces, tuple(quote for _, quote in kept))

    def _places(self) -> Iterator[tuple[int, int, str]]:
        """Where each piece begins and ends, and its quote."""
        starts = [inner for inner, _ in self.pieces or ()]
        return zip(starts, (*starts[1:], len(self)), self.quotes)

    def stretches(self) -> Iterator[tuple[Word, str]]:
        """The parts of it that are quoted in one way, each with its quote."""
        if not self.quotes:
            yield self, ""
        for quote, group in groupby(self._places(), key=lambda place: place[2]):
            stretch = list(group)
            yield self.part(stretch[0][0], stretch[-1][1]), quote


class HereDocument(NamedTuple):
    """The lines between ``<<WORD`` and WORD."""

    text: Located
    """As it is written, with the end of its last line."""
    quoted: bool
    """Nothing in it is expanded."""
    tabs: bool
    """``<<-``: the tabs at the start of a line are left out."""


class Redirect(NamedTuple):
    """``> FILE``, ``<<WORD`` and the like."""

    operator: str
    descriptor: str
    """The number before the operator; empty for the usual one."""
    target: Located | None
    document: HereDocument | None = None

    @property
    def writes(self) -> bool:
        """Whether standard output goes to the file."""
        return self.operator in (">", ">>", ">|", "&>", "&>>") and self.descriptor in ("", "1")

    @property
    def appends(self) -> bool:
        return self.operator in (">>", "&>>")


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
    """How many compound commands (if, while, functions, subshells) it is in."""
    redirects: tuple[Redirect, ...] = ()

    @property
    def name(self) -> str:
        """The last component of the program's path; empty for bare assignments."""
        return self.words[0].rpartition("/")[2] if self.words else ""

    @property
    def hides_errors(self) -> bool:
        """Whether what it says of errors goes elsewhere, so that its failure is expected."""
        return any(each.descriptor == "2" or each.operator in ("&>", "&>>") for each in self.redirects)

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
    """The words that a ``for`` goes through; for ``for ((...))`` the one arithmetic text; for a ``case`` the last
    pattern of each branch."""
    condition: tuple[Block, ...] = ()
    bodies: tuple[tuple[Block, ...], ...] = ()
    """The body; for ``branches`` every branch."""
    arrays: tuple[tuple[str, int], ...] = ()
    """Arrays that a command assigns: name and number of words."""
    arithmetic: Located | None = None
    """The text of ``((...))``."""
    redirects: tuple[Redirect, ...] = ()
    """The redirections of a compound command."""
    ends: str = ""
    """What ends a compound command, as in ``Command``."""
