"""How long a shell script may wait: the sleeps and polling loops whose bounds are in it.

The result is what the script may certainly spend waiting when what it waits for is late; whatever cannot be
read counts as 0.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

from bringup_lint.dataclass import dataclass
from bringup_lint.graph.commands.shells import SCRIPT_DEPTH
from bringup_lint.graph.commands.shells import SHELL_SCRIPT
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.shells import shell_input
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.files import Files
from bringup_lint.graph.systemd.loops import Names
from bringup_lint.graph.systemd.loops import flat
from bringup_lint.graph.systemd.loops import limits_in
from bringup_lint.graph.systemd.loops import raised_in
from bringup_lint.graph.systemd.loops import rounds
from bringup_lint.graph.systemd.process import Process
from bringup_lint.model.shell import Block
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import blocks
from bringup_lint.parsers.shell import script_blocks
from bringup_lint.parsers.systemd_values import nowhere
from bringup_lint.source import Located
from bringup_lint.source import Span

STEPS = 20_000
"""Statements that are looked at for one command line."""


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


def longest_wait(process: Process, files: Files) -> Wait:
    """How long a command line may wait before it ends (ExecStartPre=) or becomes the daemon (ExecStart=)."""
    return _Waits(files).command(Command(process.argv), Names(), 0)


@dataclass
class _Waits:
    files: Files
    budget: int = STEPS

    def all(self, found: Iterable[Block], names: Names, depth: int) -> Wait:
        total = NONE
        for block in found:
            total = total.plus(self.one(block, names, depth))
        return total

    def one(self, block: Block, names: Names, depth: int) -> Wait:
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

    def counted(self, block: Block, names: Names, depth: int) -> Wait:
        count = rounds(block, names)
        outer = names.values.get(block.name)
        names.values[block.name] = None
        each = self.all(block.bodies[0], names, depth)
        names.values[block.name] = outer
        if not count or not each.seconds:
            return NONE
        if each.times > 1:
            return each._replace(seconds=count * each.seconds)
        return Wait(count * each.seconds, each.where, count, each.seconds)

    def polled(self, block: Block, names: Names, depth: int) -> Wait:
        """``while``: bounded when a counter that the body raises is compared with a limit."""
        body = block.bodies[0]
        statements = list(flat((*block.condition, *body)))
        raised = dict(raised_in(statements, names))
        start = {name: names.number(f"${name}") or 0.0 for name in raised}
        each = self.all((*block.condition, *body), names, depth)
        rounds = [
            math.ceil((limit + extra * raised[name] - start[name]) / raised[name])
            for name, limit, extra in limits_in(statements, names)
            if raised.get(name)
        ]
        return Wait(max(min(rounds), 0) * each.seconds, each.where) if rounds and each.seconds else NONE

    def command(self, command: Command, names: Names, depth: int) -> Wait:
        if not command.words:
            names.assign(command.assignments)
            return NONE
        if command.background:
            return NONE
        words, name = command.words, command.name
        if name == "timeout":
            limit = next((names.number(word) for word in words[1:] if not word.startswith("-")), None)
            return Wait(limit, words[0].span) if limit else NONE
        if name in ("local", "declare", "readonly", "export", "typeset"):
            names.assign(word for word in words[1:] if "=" in word)
            return NONE
        if name == "sleep":
            return _sleep(words, names)
        if str(words[0]) in names.functions:
            body = names.functions[str(words[0])]
            return self.all(body, names.inside(words[1:]), depth + 1) if depth < 8 else NONE
        return self.program(unwrapped(words), names, depth)

    def program(self, words: tuple[Located, ...], names: Names, depth: int) -> Wait:
        if not words or depth >= SCRIPT_DEPTH + 8:
            return NONE
        name = program_name(words[0])
        if name == "sleep":
            return self.command(Command(words), names, depth)
        if name not in SHELLS:
            return self.script(words[0], words[1:], names, depth) if words[0].startswith("/") else NONE
        read = shell_input(words[1:])
        if read is None:
            return NONE
        if read.script is not None:
            return self.script(read.script, read.arguments, names, depth)
        text = read.text or words[0].part(0, 0)
        return self.all(blocks(nowhere(text.replace("$$", "$")) if "$$" in text else text), Names(), depth + 1)

    def script(self, path: Located, arguments: tuple[Located, ...], names: Names, depth: int) -> Wait:
        source = self.files.tree.find(path) if "$" not in path and "%" not in path else None
        if source is None or not (SHELL_SCRIPT.match(source.text) or source.name.endswith(".sh")):
            return NONE
        inner = Names(arguments=tuple(names.text(word) or "" for word in arguments))
        return self.all(script_blocks(source), inner, depth + 1)


def _sleep(words: tuple[Located, ...], names: Names) -> Wait:
    total = 0.0
    for word in words[1:]:
        seconds = names.number(word)
        if seconds is None:
            return NONE
        total += seconds
    return Wait(total, words[0].span) if words[1:] else NONE
