"""Command lines: what the ``Exec*=`` settings run, systemd.service(5)."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import replace
from bringup_lint.parsers.systemd_values.paths import is_absolute
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import NOTHING
from bringup_lint.parsers.systemd_values.problems import UNIT
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import check_specifiers
from bringup_lint.parsers.systemd_values.specifiers import literal
from bringup_lint.parsers.systemd_values.word_splitting import BLANKS
from bringup_lint.parsers.systemd_values.word_splitting import DECODE_RELAXED
from bringup_lint.parsers.systemd_values.word_splitting import extract
from bringup_lint.source import Located


@dataclass(frozen=True)
class Command:
    """One command. Quotes are gone and escapes decoded; specifiers and variables are as written."""

    where: Located
    """The whole command, prefixes and all, as written."""
    prefixes: str
    """The characters before the program, out of ``@-:+!``."""
    program: Located
    """A path or a bare name."""
    arguments: tuple[Located, ...]
    argv0: Located | None = None
    """The name the program sees, with the prefix ``@``; it is not among the arguments."""

    @property
    def argv(self) -> tuple[Located, ...]:
        """The program and its arguments."""
        return (self.program, *self.arguments)

    @property
    def ignores_failure(self) -> bool:
        return "-" in self.prefixes

    @property
    def expands_variables(self) -> bool:
        return ":" not in self.prefixes

    @property
    def privileged(self) -> bool:
        """Runs with full privileges, whatever User= says (``+``)."""
        return "+" in self.prefixes


@dataclass(frozen=True)
class CommandLine:
    commands: tuple[Command, ...]
    problems: tuple[ValueProblem, ...]
    """Quoting and escapes only; ``check_command_line`` judges the programs and specifiers too."""


def split_command_line(value: Located) -> CommandLine:
    """The commands of an ``Exec*=`` value, in order; a lone ``;`` separates them."""
    commands: list[Command] = []
    problems: list[ValueProblem] = []
    at = 0
    while at >= 0:
        first = extract(value, at, escapes=DECODE_RELAXED)
        problems += _relaxed(first.problems, LINE)
        if first.word is None or first.broken:
            break
        if first.word == ";":
            at = first.next
            continue
        start = _after_blanks(value, at)
        words, stop, at, bad = _arguments(value, first.next)
        count = _prefix_length(first.word)
        prefixes, program = str(first.word[:count]), first.word.part(count, len(first.word))
        problems += _relaxed(bad, LINE if "-" in prefixes else UNIT)
        argv0 = words.pop(0) if "@" in prefixes and words else None
        where = value.part(start, _before_blanks(value, stop))
        commands.append(Command(where, prefixes, program, tuple(words), argv0))
    return CommandLine(tuple(commands), tuple(problems))


def _after_blanks(value: str, at: int) -> int:
    """Where the blanks that begin at a place end; the value is not copied, as it may be long."""
    while at < len(value) and value[at] in BLANKS:
        at += 1
    return at


def _before_blanks(value: str, at: int) -> int:
    """Where the blanks that end at a place begin."""
    while at > 0 and value[at - 1] in BLANKS:
        at -= 1
    return at


def _arguments(value: Located, at: int) -> tuple[list[Located], int, int, list[ValueProblem]]:
    """Words up to the separator, where the command ends and the next one starts (-1: none), and problems."""
    words: list[Located] = []
    problems: list[ValueProblem] = []
    while at >= 0:
        if value[at] == ";" and value[at + 1 : at + 2] in (" ", "\t", "\n", "\r", ""):
            rest = at + 1
            return words, at, rest if _after_blanks(value, rest) < len(value) else -1, problems
        if value[at : at + 2] == "\\;" and value[at + 2 : at + 3] in (" ", "\t", "\n", "\r", ""):
            words.append(value.part(at + 1, at + 2))
            after = _after_blanks(value, at + 2)
            at = after if after < len(value) else -1
            continue
        found = extract(value, at, escapes=DECODE_RELAXED)
        problems += found.problems
        if found.word is None or found.broken:
            return words, len(value), -1, problems
        words.append(found.word)
        at = found.next
    return words, len(value), -1, problems


def _relaxed(problems: Iterable[ValueProblem], effect: str) -> Iterator[ValueProblem]:
    for problem in problems:
        yield replace(problem, effect=NOTHING if problem.code == "unknown-escape" else effect)


def _prefix_length(word: str) -> int:
    """How many characters in front are prefixes: each once, and one privilege mark (``!!`` is one)."""
    seen = ""
    at = 0
    while at < len(word):
        char = word[at]
        if (char in "-@:" and char not in seen) or (
            (char == "+" and not set("+!") & set(seen)) or (char == "!" and "+" not in seen and seen.count("!") < 2)
        ):
            seen += char
        else:
            break
        at += 1
    return at


def check_command_line(value: Located, version: int) -> Iterator[ValueProblem]:
    line = split_command_line(value)
    yield from line.problems
    for command in line.commands:
        effect = LINE if command.ignores_failure else UNIT
        bad = list(check_specifiers(command.program, version, effect))
        yield from bad or _check_program(command, effect)
        if command.argv0 is not None:
            yield from check_specifiers(command.argv0, version, effect)
        elif "@" in command.prefixes:
            yield ValueProblem("empty-command", command.where, "the name that the program sees, after the path", effect)
        for argument in command.arguments:
            yield from check_specifiers(argument, version, effect)


def _check_program(command: Command, effect: str) -> Iterator[ValueProblem]:
    program = command.program
    text = literal(program)
    if not program:
        yield ValueProblem("empty-command", command.where, "a program", effect)
    elif any(ord(char) < 32 or char in "'\"\\\x7f" for char in program):
        yield ValueProblem("bad-program", program, "a program without quotes and control characters", effect)
    elif program.endswith("/"):
        yield ValueProblem("bad-program", program, "a program, not a folder", effect)
    elif text is not None and is_absolute(program) is False and ("/" in text or text in (".", "..")):
        yield ValueProblem("not-absolute", program, "an absolute path or the bare name of a program", effect)
