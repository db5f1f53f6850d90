"""What a script does, command by command: what it writes, copies and runs, and whether it surely does."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import shell_input
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.installed.text import Text
from bringup_lint.graph.installed.text import document
from bringup_lint.graph.installed.text import echoed
from bringup_lint.graph.installed.text import plain
from bringup_lint.graph.installed.text import printed
from bringup_lint.model.shell import Block
from bringup_lint.model.shell import Command
from bringup_lint.model.shell import Redirect
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import blocks
from bringup_lint.parsers.shell import flatten
from bringup_lint.parsers.shell import script_blocks
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Origin
from bringup_lint.source import Source
from bringup_lint.source import Span

STEPS = 20_000
"""Statements that are looked at in one script."""
_DEPTH = 8
_AS_ROOT = regex(r"\$\{?\w*sudo\w*\}?|run_sudo|as_root|maybe_sudo", re.I)
_TESTS = ("[", "[[", "test", "grep", "command", "which", "getent", "id", "dpkg", "systemctl")
_DECLARING = ("export", "local", "readonly", "declare", "typeset")
_NEEDS_ROOT = regex(r"\bEUID\b|\bid\s+-u\b|\bwhoami\b|\$\{?UID\b|\bSUDO_USER\b")
_OF_ROOT = regex(r"/(?:etc|usr|lib|boot|sys|proc|root|var/lib)/")
_LITERAL = regex(r"[^{}\n]*")


class Run(NamedTuple):
    """One command that a script runs."""

    command: Command
    words: tuple[Located, ...]
    """Without ``sudo`` and the like."""
    certain: bool
    """Not only under a condition."""
    values: dict[str, str | None]
    """The variables at this place."""
    given: Text | None = None
    """What it reads from its standard input, where that is known."""
    by_root: bool = False
    """``sudo`` or the like is before it."""
    shell: str = ""
    """The shell whose ``-c`` has it; empty: that of the script."""

    @property
    def name(self) -> str:
        return program_name(self.words[0]) if self.words else ""

    def text(self, word: Located) -> str:
        """A word with the variables that are known."""
        return plain(word, self.values)

    def given_at(self, start: int, end: int) -> Span:
        """Where a stretch of its standard input is in the script."""
        where = self.command.words[0].span
        return Origin(where, self.given.pieces if self.given else ()).span(start, end)

    @property
    def reads_input(self) -> int:
        """For a shell: the number of words that follow when it reads its script from its standard input."""
        return len(self.words) - 1 if len(self.words) > 1 and self.words[1] in ("-", "-s", "-x", "-e") else 0

    @property
    def arguments(self) -> list[str]:
        return [self.text(word) for word in self.words[1:]]


class Written(NamedTuple):
    """A file that a script writes."""

    path: str
    """As the script names it, with placeholders for what is not known."""
    text: Text | None
    """None: it is not known."""
    appends: bool
    where: Located
    certain: bool
    refused: bool = False
    """``sudo command > file`` or ``sudo command | tee file``: who opens the file is not root, and may not."""
    by_shell: bool = True
    """The shell opens it, without ``sudo`` before it."""


def runs(source: Source) -> Iterator[Run | Written]:
    """What a script does, in its order."""
    statements = script_blocks(source)
    reader = _Reader(_constants(statements), has_root=bool(_NEEDS_ROOT.search(source.text)))
    yield from reader.statements(statements, True, 0)
    for name, body in list(reader.functions.items()):
        if name not in reader.called:
            yield from reader.statements(body, False, 1)


def _constants(statements: tuple[Block, ...]) -> dict[str, str | None]:
    """The variables of the script: None for all that are not assigned one literal value."""
    found: dict[str, set[str | None]] = {}
    known: dict[str, str | None] = {}
    """Those that have had one value so far."""
    for command in flatten(statements):
        words = command.assignments
        if command.name in _DECLARING:
            words = command.words[1:]
        elif command.name == "read":
            for word in command.words[1:]:
                _add(found, known, str(word), None)
        elif command.words:
            continue
        for word in words:
            name, equals, _ = word.partition("=")
            if equals:
                value = plain(word.part(len(name) + 1, len(word)), known) if name.isidentifier() else None
                literal = value if value is not None and _LITERAL.fullmatch(value) else None
                _add(found, known, name.rstrip("+"), literal)
    return {name: known.get(name) for name in found}


def _add(found: dict[str, set[str | None]], known: dict[str, str | None], name: str, value: str | None) -> None:
    values = found.setdefault(name, set())
    values.add(value)
    if len(values) == 1:
        known[name] = value
    else:
        known.pop(name, None)


def _is_refused(block: Block, did: Written) -> bool:
    """Whether ``tee`` opens a file of root as the user who runs the script."""
    by_tee = block.command is not None and bool(block.command.words) and block.command.words[0] == "tee"
    return by_tee and _OF_ROOT.match(did.path) is not None


def _without_sudo(words: tuple[Located, ...]) -> tuple[tuple[Located, ...], bool]:
    """The words of the program that runs in the end, without those that start it, and whether it runs as root."""
    by_root = False
    while words and (_AS_ROOT.fullmatch(words[0]) or unwrapped(words) != words):
        rest = words[1:] if _AS_ROOT.fullmatch(words[0]) else unwrapped(words)
        before = words[: len(words) - len(rest)]
        by_root |= any(_AS_ROOT.fullmatch(word) or program_name(word) == "sudo" for word in before)
        words = rest
    return words, by_root


@dataclass
class _Reader:
    values: dict[str, str | None]
    functions: dict[str, tuple[Block, ...]] = field(default_factory=dict)
    called: set[str] = field(default_factory=set)
    has_root: bool = False
    """The script asks for root to start it."""
    budget: int = STEPS

    def statements(self, body: Iterable[Block], certain: bool, depth: int) -> Iterator[Run | Written]:
        piped: Text | None = None
        guarded = False
        sudo = False
        for block in body:
            self.budget -= 1
            if self.budget < 0 or depth > _DEPTH:
                return
            for did in self.statement(block, certain and not guarded, piped, depth):
                if sudo and isinstance(did, Written) and _is_refused(block, did):
                    did = did._replace(refused=True)
                yield did
            ends = block.command.ends if block.command else block.ends
            piped = self.standard_output(block, piped) if ends == "|" else None
            sudo = ends == "|" and (sudo or self.is_sudo(block.command))
            tested = block.command is not None and block.command.name in _TESTS
            guarded = ends == "||" or (ends in ("&&", "|") and (guarded or (tested and ends == "&&")))

    def is_sudo(self, command: Command | None) -> bool:
        """Whether a command asks for root itself, so that the script is not run by root."""
        return command is not None and bool(command.words) and command.words[0] == "sudo" and not self.has_root

    def statement(self, block: Block, certain: bool, piped: Text | None, depth: int) -> Iterator[Run | Written]:
        if block.kind == "function":
            self.functions[block.name] = block.bodies[0]
        elif block.command is not None:
            yield from self.command(block.command, certain, piped, depth)
        elif block.kind in ("branches", "for", "loop"):
            yield from self.statements(block.condition, certain, depth + 1)
            for body in block.bodies:
                yield from self.statements(body, False, depth + 1)
        elif block.kind == "group":
            yield from self.statements(block.bodies[0], certain, depth + 1)
            yield from self.redirected(block.redirects, lambda: self.standard_output(block, None), certain)

    def command(self, command: Command, certain: bool, piped: Text | None, depth: int) -> Iterator[Run | Written]:
        words, by_root = _without_sudo(command.words)
        given = self.standard_input(command, piped)
        yield Run(command, words, certain, self.values, given, by_root)
        name = program_name(words[0]) if words else ""
        if name == "tee":
            yield from self.tee(words, given, certain)
        elif name in SHELLS:
            yield from self.shell(words, certain, depth, by_root)
        elif name in self.functions and name not in self.called:
            self.called.add(name)
            yield from self.statements(self.functions[name], certain, depth + 1)
        for each in self.redirected(command.redirects, lambda: self.printed(words, given), certain):
            yield each._replace(refused=True) if self.is_sudo(command) and _OF_ROOT.match(each.path) else each

    def shell(self, words: tuple[Located, ...], certain: bool, depth: int, by_root: bool) -> Iterator[Run | Written]:
        read = shell_input(words[1:])
        if read is not None and read.text is not None:
            shell = program_name(words[0])
            for did in self.statements(blocks(read.text), certain, depth + 1):
                if isinstance(did, Run):
                    yield did._replace(shell=did.shell or shell, by_root=did.by_root or by_root)
                else:
                    yield did._replace(by_shell=did.by_shell and not by_root)

    def tee(self, words: tuple[Located, ...], given: Text | None, certain: bool) -> Iterator[Written]:
        appends = any(re.fullmatch(r"-[a-z]*a[a-z]*|--append", word) for word in words[1:])
        for word in words[1:]:
            if not word.startswith("-"):
                yield Written(plain(word, self.values), given, appends, word, certain, by_shell=False)

    def redirected(
        self, redirects: Iterable[Redirect], output: Callable[[], Text | None], certain: bool
    ) -> Iterator[Written]:
        for each in redirects:
            if each.writes and each.target is not None and each.target != "/dev/null":
                yield Written(plain(each.target, self.values), output(), each.appends, each.target, certain)

    def standard_input(self, command: Command, piped: Text | None) -> Text | None:
        for each in command.redirects:
            if each.document is not None:
                return document(each.document, self.values)
            if each.operator == "<<<" and each.target is not None:
                return echoed([each.target], self.values)
            if each.operator == "<":
                return None
        return piped

    def printed(self, words: tuple[Located, ...], given: Text | None) -> Text | None:
        """What a command writes to its standard output; None where it is not known."""
        name = program_name(words[0]) if words else ""
        if name == "echo":
            return echoed(words[1:], self.values)
        if name == "printf":
            return printed(words[1:], self.values)
        if name in ("cat", "tee") and (name == "tee" or not [word for word in words[1:] if word != "-"]):
            return given
        return None

    def standard_output(self, block: Block, piped: Text | None) -> Text | None:
        if block.command is not None:
            words, _ = _without_sudo(block.command.words)
            return self.printed(words, self.standard_input(block.command, piped))
        if block.kind != "group":
            return None
        whole = Text()
        for each in block.bodies[0]:
            text = self.standard_output(each, None)
            if text is None:
                return None
            whole.extend(text)
        return whole
