"""What systemd makes of every single line of the unit files: known or not, accepted or not, and what follows."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from functools import cached_property

from bringup_lint import facts
from bringup_lint.dataclass import dataclass
from bringup_lint.facts.systemd.directives import Directive
from bringup_lint.facts.systemd.directives import directive
from bringup_lint.facts.systemd.directives import sections_of_type
from bringup_lint.model.unit import Assignment
from bringup_lint.model.unit import UnitFile
from bringup_lint.parsers.systemd_values import Command
from bringup_lint.parsers.systemd_values import ValueProblem
from bringup_lint.parsers.systemd_values import Variable
from bringup_lint.parsers.systemd_values import check
from bringup_lint.parsers.systemd_values import is_unit_name
from bringup_lint.parsers.systemd_values import split_command_line
from bringup_lint.parsers.systemd_values import split_environment
from bringup_lint.parsers.systemd_values.word_splitting import extract
from bringup_lint.pattern import regex
from bringup_lint.source import Located

_VARIABLE = regex(r"\$(?:\{[A-Za-z_][^}]{0,400}\}|[A-Za-z_][A-Za-z0-9_]*)")
_FREE_TEXT = frozenset(
    {"command", "any", "ignored", "base64", "credential-value", "string", "label", "condition-string"}
)
_COMMENTS_ALLOWED = frozenset({"command", "any", "ignored", "base64", "credential-value"})
_PROSE = frozenset({"Description", "StandardInputText", "LogFilterPatterns"})


@dataclass(frozen=True)
class Line:
    """An assignment that its section knows."""

    file: UnitFile
    assignment: Assignment
    directive: Directive
    comment: Located | None
    """Text behind the value that was meant as a comment; the value is then not judged any further."""
    variable: Located | None
    """A ``$NAME`` where systemd expands none; the value is then not judged any further."""
    problems: tuple[ValueProblem, ...]

    @property
    def key(self) -> Located:
        return self.assignment.key

    @property
    def value(self) -> Located:
        return self.assignment.value

    @property
    def commands(self) -> tuple[Command, ...]:
        """What an Exec line runs; nothing for other keys and for values that a template fills in."""
        if self.directive.type != "command" or self.assignment.opaque:
            return ()
        return self._commands

    @cached_property
    def _commands(self) -> tuple[Command, ...]:
        return split_command_line(self.value).commands

    @property
    def environment(self) -> tuple[Variable, ...]:
        """What an Environment= line sets; nothing for other keys."""
        return split_environment(self.value) if self.directive.type == "environment" else ()

    def consequence(self, problem: ValueProblem) -> str:
        """What happens on the robot, as a clause."""
        if problem.effect == "unit":
            return "the unit does not load"
        if problem.effect == "word":
            return "systemd ignores this word"
        if problem.effect == "nothing":
            return "systemd uses it unchanged"
        default = default_of(self.key) if self._alone else ""
        return f"systemd ignores the line and {default}" if default else "systemd ignores the line"

    @property
    def _alone(self) -> bool:
        same = [found for found in self.file.assignments if found.key == self.key]
        return len(same) == 1 and not self.file.dropin


def lines(files: list[UnitFile], version: int) -> Iterator[Line]:
    """Every line with a known key in a section that its unit may have."""
    for file in files:
        allowed = sections_of_type(file.type)
        for assignment in file.assignments:
            known = directive(assignment.section, assignment.key) if assignment.section in allowed else None
            if known is not None:
                yield _line(file, assignment, known, version)


def _line(file: UnitFile, assignment: Assignment, known: Directive, version: int) -> Line:
    if assignment.opaque or not assignment.value:
        return Line(file, assignment, known, None, None, ())
    value = assignment.value
    comment = None
    if known.type not in _COMMENTS_ALLOWED and known.key not in _PROSE and ("#" in value or ";" in value):
        comment = trailing_comment(value, names=known.type in ("units", "install-units"))
    variable = None if comment or known.type in _FREE_TEXT or "$" not in value else _variable(value, known.type)
    problems = () if comment or variable else tuple(check(known.type, value, version))
    return Line(file, assignment, known, comment, variable, problems)


def trailing_comment(value: Located, *, names: bool = False) -> Located | None:
    """What follows a blank and ``#`` or ``;``, outside quotes. A ``;`` between unit names separates them."""
    at = 0
    while at >= 0:
        start = len(value) - len(value[at:].lstrip(" \t"))
        mark = value[start : start + 1]
        if mark == "#" or (mark == ";" and start):
            rest = value.part(start, len(value))
            separator = mark == ";" and names and all(is_unit_name(word.strip(";")) for word in rest[1:].split())
            return None if separator else rest
        found = extract(value, at, escapes="drop")
        if found.broken:
            return None
        at = found.next
    return None


def _variable(value: Located, kind: str) -> Located | None:
    found = _VARIABLE.search(value)
    if found is None:
        return None
    if kind == "environment" and found.start() and value[found.start() - 1] not in "=:/, \t\"'":
        return None
    return value.part(*found.span())


@cache
def _defaults() -> dict[str, str]:
    return {row[0]: row[1] for row in facts.rows("systemd/defaults")[1]}


def default_of(key: str) -> str:
    """What applies when nothing sets the key, as a clause; empty when the tables do not say."""
    return _defaults().get(key, "")
