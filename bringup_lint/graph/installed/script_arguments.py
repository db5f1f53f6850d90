"""Scripts of the tree that are called with fewer arguments than they read (POSIX, Shell Command Language, 2.5.1)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Sequence
from functools import cache

from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.model.shell import Block
from bringup_lint.model.shell import Command
from bringup_lint.model.shell import Word
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import shell_blocks
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_HANDLED = regex(r"\$#|\$\{#|\bshift\b|\bgetopts?\b|\$[@*]|\$\{[@*]|\bBASH_ARGV\b|\bset[ \t]+(?:--[ \t]|\"?\$)")
"""The script sees itself how many arguments there are."""
_NOUNSET = regex(
    r"^[ \t]*set[ \t]+-(?:[a-zA-Z]{0,9}u|o[ \t]+nounset|[a-zA-Z]{1,9}[ \t]+-u)|^#![^\n]{0,40}[ \t]-[a-z]{0,9}u", re.M
)
_USED = regex(r"\$(?P<plain>[1-9])|\$\{(?P<braced>[1-9])\}")
_FIELDS = regex(r"\bg?awk\b|\bperl\b|\bsed\b")
"""Programs with variables of these names, which a command substitution may hold."""
_VARIABLE = regex(r"\$\w+")
"""As a word of its own, systemd splits it."""
_ASSIGNED = regex(r"(?P<name>[A-Za-z_]\w*)=\$(?:[1-9]|\{[1-9]\})")
_TESTED = r"\$\{{{name}[:=?+-]|(?:\[|\btest[ \t]|\bcase[ \t])[^\n]*\$\{{?{name}\b"
_GUARDED = regex(r"\$\{(\d)[:=?+-]|\bcase[ \t]+\"?\$\{?(\d)")
_TESTS = ("[", "[[", "test", "case")
_SHELLS = ("bash", "sh", "dash")
_SEVERAL = regex(r"[*?\[]|\{[^{}\n]*(?:,|\.\.)[^{}\n]*\}|\$[@*]|\$\{\w+\[[@*]\]|\$\(")


class ShortCall(NamedTuple):
    """A call with fewer arguments than the script reads."""

    script: Source
    words: Sequence[Located]
    """The script and its arguments."""
    lacking: list[Located]
    """The first word of the script that reads each argument."""

    @property
    def stops(self) -> bool:
        """Whether the script ends where it reads what it was not given."""
        return _NOUNSET.search(self.script.text) is not None


Call = tuple[Source, Sequence[Located]]
"""The file that calls, and the words of the command."""


def short_calls(scripts: Iterable[Source], calls: Iterable[Call]) -> Iterator[ShortCall]:
    """The calls of scripts by their path that give too few arguments."""
    by_name: dict[str, list[Source]] = {}
    for source in scripts:
        by_name.setdefault(source.basename, []).append(source)
    uses = cache(_uses)
    for caller, command in calls:
        words = _from_script(command)
        script = _called(by_name, caller, words)
        if script is None or script is caller or any(map(_may_be_several, words)):
            continue
        lacking = [use for number, use in sorted(uses(script).items()) if number >= len(words)]
        if lacking:
            yield ShortCall(script, words, lacking)


def _from_script(words: Sequence[Located]) -> Sequence[Located]:
    return words[1:] if len(words) > 1 and program_name(words[0]) in _SHELLS else words


def _called(by_name: dict[str, list[Source]], caller: Source, words: Sequence[Located]) -> Source | None:
    """The script of the tree that a path means: the one beside the caller, else the only one of its name."""
    if not words or "/" not in words[0] or not words[0].endswith((".sh", ".bash")):
        return None
    named = by_name.get(posixpath.basename(words[0]), [])
    beside = posixpath.normpath(posixpath.join(posixpath.dirname(caller.name), words[0]))
    fitting = [each for each in named if each.name == beside] or [each for each in named if _may_be(each, words[0])]
    return fitting[0] if len(fitting) == 1 else None


def _may_be(script: Source, path: str) -> bool:
    """Whether a path may mean a script: from the top of the tree, from a variable on, or on the robot by the name of
    its folder, too."""
    if "$" in path:
        return f"/{script.name}".endswith(f"/{path.rpartition('$')[2].partition('/')[2]}")
    if path.startswith("/"):
        return script.name.split("/")[-2:] == path.split("/")[-2:]
    return script.name == posixpath.normpath(path)


def _uses(script: Source) -> dict[int, Located]:
    """The arguments that a script surely reads, with the first word that does."""
    if _HANDLED.search(script.text) or script.template:
        return {}
    strict = _NOUNSET.search(script.text) is not None
    found: dict[int, Located] = {}
    optional = _guarded(script.text)
    for command in _sure_commands(script):
        for word in (*command.words, *command.assignments):
            for number in _numbers(word):
                found.setdefault(number, word)
                if _tests(command) or (not strict and _is_optional(script, command, word)):
                    optional.add(number)
    return {number: word for number, word in found.items() if number not in optional}


def _guarded(text: str) -> set[int]:
    """The arguments with a default, and those that a ``case`` looks at."""
    return {int(number) for match in _GUARDED.finditer(text) for number in match.groups() if number}


def _tests(command: Command) -> bool:
    return command.name in _TESTS or command.ends in ("||", "&&")


def _is_optional(script: Source, command: Command, word: Located) -> bool:
    """Whether an empty argument is seen to: a last word without quotes is not there then, and a variable may be
    tested later."""
    if command.words and word is command.words[-1] and _is_bare(word):
        return True
    assigned = _ASSIGNED.fullmatch(word)
    return assigned is not None and re.search(_TESTED.format(name=re.escape(assigned["name"])), script.text) is not None


def _is_bare(word: Located) -> bool:
    """Whether it is an argument alone, without quotes."""
    return _USED.fullmatch(word) is not None and all(not quote for _, quote in _stretches(word))


def _sure_commands(script: Source) -> Iterator[Command]:
    return (block.command for block in _top(shell_blocks(script)) if block.command is not None)


def _numbers(word: Located) -> Iterator[int]:
    if _FIELDS.search(word):
        return
    for part, quote in _stretches(word):
        if quote != "'":
            yield from (int(match["plain"] or match["braced"]) for match in _USED.finditer(part))


def _stretches(word: Located) -> Iterator[tuple[Located, str]]:
    """The parts of a word with their quotes; without any for a word of another file than a script."""
    if isinstance(word, Word):
        yield from word.stretches()
    else:
        yield word, ""


def _may_be_several(word: Located) -> bool:
    """Whether the shell or systemd may make several arguments of a word, or none."""
    if _SEVERAL.search(word):
        return True
    if not isinstance(word, Word):
        return _VARIABLE.fullmatch(word) is not None
    return any("$" in part and not quote for part, quote in word.stretches())


def _top(blocks: Sequence[Block]) -> Iterator[Block]:
    """The statements that run in any case: not those of functions and branches."""
    for block in blocks:
        yield block
        if block.kind == "group":
            yield from _top(block.bodies[0])
        elif block.kind == "branches":
            yield from (each for each in block.condition)
