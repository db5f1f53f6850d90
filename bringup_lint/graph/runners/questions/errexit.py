"""The commands of a script whose failure ends it, by ``set -e`` (POSIX.1-2017, 2.14 "set"; bash(1))."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from bringup_lint.graph.commands.shells import STRICT
from bringup_lint.graph.runners.questions.every_command import with_inner
from bringup_lint.model.shell import Block
from bringup_lint.model.shell import Command
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import flatten
from bringup_lint.parsers.shell import script_blocks
from bringup_lint.parsers.shell import shell_commands
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_ERREXIT = regex(STRICT, re.M)
_SHEBANG = regex(r"#!\S+[ \t]+-\w*e\w*[ \t]*(?:\n|\Z)")
_ON = regex(r"-[a-zA-Z]*e[a-zA-Z]*")
_OFF = regex(r"\+[a-zA-Z]*e[a-zA-Z]*")
_VARIABLE = regex(r"\$(?:\{[^{}]{0,80}\}|\w+|[@*#?$!-])")
_WORD = regex(r"[\w-]+")
_FORMS = 20
"""Names with variables in them that are looked at: a script with more of them may call anything."""
_LISTS = ("&&", "||")
_ENDS = ("", "\n", ";")
_TAKE_WORDS = frozenset(
    "local export declare readonly typeset set echo printf trap true : exec unset systemctl service".split()
)
"""Commands whose arguments are no commands that they run under a condition."""


class Statement(NamedTuple):
    """One statement among those of its list."""

    among: tuple[Block, ...]
    at: int

    @property
    def block(self) -> Block:
        return self.among[self.at]

    @property
    def after(self) -> str:
        """What ends the statement before it."""
        return _ends(self.among[self.at - 1]) if self.at else "\n"


def ended_by_failure(source: Source) -> Iterator[Statement]:
    """The simple commands and ``((...))`` of a script whose failure surely ends it; nothing of a function that is
    called where ``set -e`` has no effect."""
    if not source.matches(_ERREXIT):
        return
    found = script_blocks(source)
    strict = _SHEBANG.match(source.text) is not None
    is_ever = strict or any(_turns_on(block) for block in found)
    is_lasting = is_ever and "set +" not in source.text
    functions = {block.name: block for block in found if block.kind == "function"}
    unsafe = _without_effect(source, found, functions) if functions and is_ever else set()
    for at, block in enumerate(found):
        if block.command is not None and block.command.name == "set":
            strict = _after_set(block.command, strict)
        elif block.kind == "function":
            if is_lasting and block.name not in unsafe:
                yield from _in_list(block.bodies[0])
        elif strict and not _turns(block):
            yield from _at(found, at)


def _turns_on(block: Block) -> bool:
    command = block.command
    return command is not None and command.name == "set" and _after_set(command, False)


def _without_effect(source: Source, found: tuple[Block, ...], functions: dict[str, Block]) -> set[str]:
    """The functions that may be called where ``set -e`` has no effect, and those that they call."""
    soft = set(_softly(found))
    unsafe = {*soft, *_handed_on(source)} & functions.keys()
    dynamic = [name for name in soft if "$" in name]
    if dynamic:
        calls = Counter(command.name for command in shell_commands(source))
        written = Counter(_WORD.findall(source.text))
        forms = {tuple(_VARIABLE.split(name)) for name in dynamic} - {("", "")}
        for name in functions:
            is_plain = _WORD.fullmatch(name) is not None and written[name] <= 1 + calls[name]
            if not is_plain or len(forms) > _FORMS or any(_is_made(name, form) for form in forms):
                unsafe.add(name)
    left = list(unsafe)
    while left:
        for command in flatten(functions[left.pop()].bodies[0]):
            if command.name in functions and command.name not in unsafe:
                unsafe.add(command.name)
                left.append(command.name)
    return unsafe


def _is_made(name: str, form: tuple[str, ...]) -> bool:
    """Whether a name consists of these parts, with anything between them."""
    if not name.startswith(form[0]):
        return False
    at, end = len(form[0]), len(name) - len(form[-1])
    for part in form[1:-1]:
        at = name.find(part, at, max(at, end)) + len(part)
        if at < len(part):
            return False
    return at <= end and name.endswith(form[-1])


def is_inverted(command: Command) -> bool:
    """Whether ``!`` is before it."""
    if not command.words:
        return False
    text, at = command.words[0].span.source.text, command.words[0].span.start
    while at and text[at - 1] in " \t":
        at -= 1
    return text[at - 1 : at] == "!"


def _softly(blocks: tuple[Block, ...], *, soft: bool = False) -> Iterator[str]:
    """The commands under whose names ``set -e`` has no effect: in conditions, and before ``&&`` and ``||``."""
    for block in blocks:
        if block.command is not None and (soft or block.command.ends in _LISTS or is_inverted(block.command)):
            yield block.command.name
        yield from _softly(block.condition, soft=True)
        for body in block.bodies:
            yield from _softly(body, soft=soft or block.ends in _LISTS)


def _handed_on(source: Source) -> Iterator[str]:
    """Words that another command may call in a condition, and the commands in ``$(...)``, where bash has no
    ``set -e``."""
    outer = shell_commands(source)
    spans = {command.words[0].span for command in outer if command.words}
    for command in with_inner(outer):
        if command.words and command.words[0].span not in spans:
            yield command.name
        if command.name not in _TAKE_WORDS:
            yield from command.words[1:]


def _after_set(command: Command, strict: bool) -> bool:
    words = command.words[1:]
    if any(map(_OFF.fullmatch, words)) or ("+o" in words and "errexit" in words):
        return False
    return strict or any(map(_ON.fullmatch, words)) or ("-o" in words and "errexit" in words)


def _turns(block: Block) -> bool:
    """Whether ``set`` is called within."""
    inner = (*block.condition, *(each for body in block.bodies for each in body))
    return any((each.command is not None and each.command.name == "set") or _turns(each) for each in inner)


def _in_list(blocks: tuple[Block, ...]) -> Iterator[Statement]:
    for at in range(len(blocks)):
        yield from _at(blocks, at)


def _at(blocks: tuple[Block, ...], at: int) -> Iterator[Statement]:
    block = blocks[at]
    if _ends(block) not in _LISTS:
        for body in block.bodies:
            yield from _in_list(body)
    if block.kind == "command" and _ends(block) in _ENDS and not (block.command and is_inverted(block.command)):
        yield Statement(blocks, at)


def _ends(block: Block) -> str:
    return block.command.ends if block.command is not None else block.ends
