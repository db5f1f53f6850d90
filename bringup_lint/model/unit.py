"""A unit file as it is written: sections and assignments, in order."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source
from bringup_lint.source import Span

_KEY = regex(r"(?:[A-Z]+[a-z]+)+[A-Z0-9]*")


@dataclass(frozen=True, slots=True)
class Assignment:
    """``Key=value`` in a section; the value is as systemd joins continued lines."""

    section: Located
    key: Located
    value: Located
    span: Span
    """The whole assignment, continued lines included, without the last line end."""
    opaque: bool = False
    """The value holds a placeholder that a build or a deployment fills in."""

    @property
    def end(self) -> Span:
        """The empty stretch behind it, where ``\\nKey=value`` adds a line."""
        return Span(self.span.source, self.span.end, self.span.end)

    def without(self, word: Located) -> tuple[Span, str]:
        """The edit that takes a word out of a list, or the whole line when it is the only one."""
        source, text = self.span.source, self.span.source.text
        start, end = word.span.start, word.span.end
        if self.value.split() == [str(word)]:
            stop = text.find("\n", self.span.end)
            return Span(source, self.span.start, len(text) if stop == -1 else stop + 1), ""
        if start > self.value.span.start:
            while start and text[start - 1] in " \t":
                start -= 1
        else:
            while end < len(text) and text[end] in " \t":
                end += 1
        return Span(source, start, end), ""


@dataclass(frozen=True, slots=True)
class Section:
    """A ``[Header]`` and what follows it. A name may occur more than once."""

    name: Located
    header: Span
    assignments: list[Assignment]

    @property
    def end(self) -> int:
        """Offset behind the last line of the section, where a new line can be inserted."""
        last = self.assignments[-1].span if self.assignments else self.header
        text = last.source.text
        at = text.find("\n", last.end)
        return len(text) if at == -1 else at + 1


@dataclass(slots=True, eq=False)
class UnitFile:
    """A unit file or drop-in."""

    source: Source
    name: str
    """The unit's name, e.g. ``robot@.service``; for a drop-in the name that its folder gives it to."""
    dropin: bool
    sections: list[Section] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    uncertain: bool = False
    """Whole lines may come and go when the template is filled in: nothing can be called absent."""

    @property
    def type(self) -> str:
        return self.name.rpartition(".")[2]

    def is_filled_in(self, key: str) -> bool:
        """Whether a build or a deployment may make another key of this one: no macro is written in CamelCase."""
        return bool(self.source.template) and not _KEY.fullmatch(key)

    @property
    def assignments(self) -> list[Assignment]:
        return [assignment for section in self.sections for assignment in section.assignments]
