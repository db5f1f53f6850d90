"""How long a shell script may wait: the sleeps and polling loops whose bounds stand in it.

The result is what the script may certainly spend waiting when what it waits for is late; whatever cannot be
read counts as 0.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import field
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.commands.command_line import SHELLS
from bringup_lint.graph.commands.following import SCRIPT_DEPTH
from bringup_lint.graph.commands.following import SHELL_SCRIPT
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.systemd.process import Process
from bringup_lint.model.shell import Block
from bringup_lint.model.shell import Command
from bringup_lint.parsers.shell_blocks import blocks
from bringup_lint.parsers.systemd_values import nowhere
from bringup_lint.source import Located
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.robot import Robot

STEPS = 20_000
"""Statements that are looked at for one command line."""

_SPAN = re.compile(r"([0-9]*\.?[0-9]+)([smhd]?)$")
_UNITS = {"": 1.0, "s": 1.0, "m": 60.0, "h": 3600.0, "d": 86400.0}
_VARIABLE = re.compile(r"\$(?:(\w+)|\{(\w+)(?::?-([^{}]*))?\})$")
_ARRAY = re.compile(r"\$\{(\w+)\[[@*]\]\}$")
_SEQUENCE = re.compile(
    r"\$\(\s*seq\s+(?:(\S+)\s+)?(?:(\S+)\s+)?(\S+?)\s*\)$|`\s*seq\s+(?:(\S+)\s+)?(?:(\S+)\s+)?(\S+?)\s*`$"
)
_BRACES = re.compile(r"\{(\d+)\.\.(\d+)\}$")
_C_LOOP = re.compile(r"\(\(\s*(\w+)\s*=\s*(\d+)\s*;\s*\w+\s*(<=?)\s*(\$?\{?\w+\}?)\s*;")
_COMPARED = {"-ge": 0, "-gt": 1, "-lt": 0, "-le": 1, "-eq": 0, ">=": 0, ">": 1, "<": 0, "<=": 1, "==": 0}
_ARITHMETIC = re.compile(r"\$?\{?(\w+)\}?\s*(>=|<=|==|>|<)\s*(\$?\{?\w+\}?)")
_GROWS = re.compile(r"(\w+)\s*(?:\+\+|\+=\s*(\$?\{?\w+\}?)|=\s*\$?\{?\1\}?\s*\+\s*(\$?\{?\w+\}?))|\+\+\s*(\w+)")
_ASSIGNED_SUM = re.compile(r"(\w+)=\$\(\(\s*\$?\{?(\w+)\}?\s*\+\s*(\$?\{?\w+\}?)\s*\)\)$")
_EXPR_SUM = re.compile(r"(\w+)=(?:\$\(|`)\s*expr\s+\$\{?(\w+)\}?\s*\+\s*(\S+?)\s*[)`]$")


class Wait(NamedTuple):
    """The longest wait and what it is made of."""

    seconds: float
    where: Span | None = None
    """The sleep that takes most of it."""
    times: int = 1
    each: float = 0.0
    """It is spent in so many rounds of so many seconds, one for each device or the like."""

    def plus(self, other: Wait) -> Wait:
        larger = self if self.seconds >= other.seconds else other
        return larger._replace(seconds=self.seconds + other.seconds)


NONE = Wait(0.0)


def longest_wait(process: Process, robot: Robot) -> Wait:
    """How long a command line may wait before it ends (ExecStartPre=) or becomes the daemon (ExecStart=)."""
    return _Waits(robot).command(Command(process.argv), _Names(), 0)


@dataclass
class _Names:
    """What the script has set so far."""

    values: dict[str, str | None] = field(default_factory=dict)
    arrays: dict[str, int] = field(default_factory=dict)
    functions: dict[str, tuple[Block, ...]] = field(default_factory=dict)
    arguments: tuple[str, ...] = ()

    def text(self, word: str) -> str | None:
        """A word that is literal, a variable, or a variable with a default."""
        match = _VARIABLE.match(word)
        if match is None:
            return None if "$" in word or "`" in word else word
        name = match[1] or match[2]
        if name.isdigit():
            at = int(name) - 1
            return self.arguments[at] if 0 <= at < len(self.arguments) else match[3]
        if name in self.values:
            found = self.values[name]
            return self.text(found) if found is not None and found != word else None
        return match[3]

    def number(self, word: str) -> float | None:
        if re.fullmatch(r"[A-Za-z_]\w*", word):
            word = f"${word}"
        text = self.text(word)
        match = _SPAN.match(text) if text else None
        return float(match[1]) * _UNITS[match[2]] if match else None


@dataclass
class _Waits:
    robot: Robot
    budget: int = STEPS

    def all(self, found: Iterable[Block], names: _Names, depth: int) -> Wait:
        total = NONE
        for block in found:
            total = total.plus(self.one(block, names, depth))
        return total

    def one(self, block: Block, names: _Names, depth: int) -> Wait:
        self.budget -= 1
        if self.budget < 0:
            return NONE
        if block.kind == "function":
            names.functions[block.name] = block.bodies[0]
            return NONE
        if block.kind == "for":
            return self.counted(block, names, depth)
        if block.kind == "loop":
            return self.polled(block, names, depth)
        if block.kind == "branches":
            start = self.all(block.condition, names, depth)
            return start.plus(max((self.all(body, names, depth) for body in block.bodies), default=NONE))
        if block.kind == "group":
            return self.all(block.bodies[0], names, depth)
        names.arrays.update(block.arrays)
        return self.command(block.command, names, depth) if block.command else NONE

    def counted(self, block: Block, names: _Names, depth: int) -> Wait:
        count = _count(block, names)
        outer = names.values.get(block.name)
        names.values[block.name] = None
        each = self.all(block.bodies[0], names, depth)
        names.values[block.name] = outer
        if not count or not each.seconds:
            return NONE
        if each.times > 1:
            return each._replace(seconds=count * each.seconds)
        return Wait(count * each.seconds, each.where, count, each.seconds)

    def polled(self, block: Block, names: _Names, depth: int) -> Wait:
        """``while``: bounded when a counter that the body raises is compared with a limit."""
        body = block.bodies[0]
        flat = list(_flat((*block.condition, *body)))
        raised = dict(_raised(flat, names))
        start = {name: names.number(f"${name}") or 0.0 for name in raised}
        each = self.all((*block.condition, *body), names, depth)
        rounds = [
            math.ceil((limit + extra * raised[name] - start[name]) / raised[name])
            for name, limit, extra in _limits(flat, names)
            if raised.get(name)
        ]
        return Wait(max(min(rounds), 0) * each.seconds, each.where) if rounds and each.seconds else NONE

    def command(self, command: Command, names: _Names, depth: int) -> Wait:
        for word in command.assignments if not command.words else ():
            name, _, value = word.partition("=")
            names.values[name.rstrip("+")] = None if name.endswith("+") else value
        if not command.words or command.background:
            return NONE
        words = command.words
        name = command.name
        if name == "timeout":
            limit = next((names.number(word) for word in words[1:] if not word.startswith("-")), None)
            return Wait(limit, words[0].span) if limit else NONE
        if name in ("local", "declare", "readonly", "export", "typeset"):
            for word in words[1:]:
                if "=" in word:
                    names.values[word.partition("=")[0]] = word.partition("=")[2]
            return NONE
        if name == "sleep":
            spans = [names.number(word) for word in words[1:]]
            return Wait(sum(spans), words[0].span) if spans and None not in spans else NONE
        if str(words[0]) in names.functions:
            inner = _Names(
                names.values,
                names.arrays,
                names.functions,
                tuple(names.text(word) or "" for word in words[1:]),
            )
            return self.all(names.functions[str(words[0])], inner, depth + 1) if depth < 8 else NONE
        return self.program(unwrapped(words), names, depth)

    def program(self, words: tuple[Located, ...], names: _Names, depth: int) -> Wait:
        if not words or depth >= SCRIPT_DEPTH + 8:
            return NONE
        name = words[0].rpartition("/")[2]
        if name == "sleep":
            return self.command(Command(words), names, depth)
        if name in SHELLS:
            for at, word in enumerate(words[1:], 1):
                if word.startswith("-") and not word.startswith("--") and "c" in word and at + 1 < len(words):
                    text = words[at + 1]
                    return self.all(
                        blocks(nowhere(text.replace("$$", "$")) if "$$" in text else text),
                        _Names(),
                        depth + 1,
                    )
                if not word.startswith(("-", "+")):
                    return self.script(words[at:], names, depth)
            return NONE
        return self.script(words, names, depth) if words[0].startswith("/") else NONE

    def script(self, words: tuple[Located, ...], names: _Names, depth: int) -> Wait:
        source = self.robot.tree.find(words[0]) if "$" not in words[0] and "%" not in words[0] else None
        if source is None or not (SHELL_SCRIPT.match(source.text) or source.name.endswith(".sh")):
            return NONE
        inner = _Names(arguments=tuple(names.text(word) or "" for word in words[1:]))
        return self.all(blocks(source.located(0, len(source.text))), inner, depth + 1)


def _count(block: Block, names: _Names) -> int:
    """How often a ``for`` goes round; 0 when that is not known."""
    total = 0
    for item in block.items:
        if not item:
            total += len(names.arguments)
        elif match := _C_LOOP.match(item):
            end = names.number(match[4])
            total += int(end - int(match[2]) + (match[3] == "<=")) if end is not None else 0
        elif item in ("$@", "$*"):
            total += len(names.arguments)
        elif match := _ARRAY.match(item):
            total += names.arrays.get(match[1], 0)
        elif match := _BRACES.match(item):
            total += abs(int(match[2]) - int(match[1])) + 1
        elif match := _SEQUENCE.match(item):
            first, step, last = match.group(1, 2, 3) if match[3] else match.group(4, 5, 6)
            ends = [names.number(word) if word else 1.0 for word in (first, step, last)]
            total += int((ends[2] - ends[0]) / ends[1]) + 1 if None not in ends and ends[1] else 0
        elif match := _VARIABLE.match(item):
            text = names.text(item)
            total += len(text.split()) if text else 0
        elif "$" not in item and "`" not in item and "*" not in item:
            total += 1
    return max(total, 0)


def _flat(found: Iterable[Block]) -> Iterable[Block]:
    for block in found:
        if block.kind in ("for", "loop", "function"):
            continue
        yield block
        yield from _flat((*block.condition, *(inner for body in block.bodies for inner in body)))


def _raised(found: list[Block], names: _Names) -> Iterable[tuple[str, float]]:
    """Variables that every round raises, and by how much."""
    for block in found:
        texts = [block.arithmetic] if block.arithmetic else []
        for word in block.command.assignments if block.command else ():
            match = _ASSIGNED_SUM.match(word) or _EXPR_SUM.match(word)
            if match and match[1] == match[2] and (step := names.number(match[3])):
                yield match[1], step
        if block.command and block.command.name in ("let", ":"):
            texts += [word.removeprefix("$((").removesuffix("))") for word in block.command.words[1:]]
        for text in texts:
            if match := _GROWS.search(text):
                step = match[2] or match[3]
                number = names.number(step) if step else 1.0
                if number:
                    yield match[1] or match[4], number


def _limits(found: list[Block], names: _Names) -> Iterable[tuple[str, float, int]]:
    """(variable, limit, 1 when it must be exceeded): comparisons that end the loop."""
    for block in found:
        for match in _ARITHMETIC.finditer(block.arithmetic):
            limit = names.number(match[3])
            if limit is not None:
                yield match[1], limit, _COMPARED[match[2]]
        words = block.command.words if block.command and block.command.name in ("[", "[[", "test") else ()
        for at, word in enumerate(words[1:-1], 1):
            if word in _COMPARED and (match := _VARIABLE.match(words[at - 1])):
                limit = names.number(words[at + 1])
                if limit is not None:
                    yield match[1] or match[2], limit, _COMPARED[str(word)]
