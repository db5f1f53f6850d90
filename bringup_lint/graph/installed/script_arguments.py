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
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.shell import shell_blocks
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_HANDLED = regex(r"\$#|\$\{#|\bshift\b|\bgetopts?\b|\$[@*]|\$\{[@*]|\bBASH_ARGV\b|\bset[ \t]+--[ \t]")
"""The script sees itself how many arguments there are."""
_NOUNSET = regex(
    r"^[ \t]*set[ \t]+-(?:[a-zA-Z]{0,9}u|o[ \t]+nounset|[a-zA-Z]{1,9}[ \t]+-u)|^#![^\n]{0,40}[ \t]-[a-z]{0,9}u", re.M
)
_USED = regex(r"\$(?P<plain>[1-9])|\$\{(?P<braced>[1-9])\}")
_FIELDS = regex(r"\bg?awk\b|\bperl\b|\bsed\b")
"""Programs with variables of these names, which a command substitution may hold."""
_TESTS = ("[", "[[", "test", "case")
_SHELLS = ("bash", "sh", "dash")
_SEVERAL = regex(r"[*?\[]|\$[@*]|\$\{\w+\[[@*]\]|\$\(")


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
        if script is None or script is caller or any(_SEVERAL.search(word) for word in words):
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
    named = [each for each in named if each.name == beside] or named
    return named[0] if len(named) == 1 else None


def _uses(script: Source) -> dict[int, Located]:
    """The arguments that a script surely reads, with the first word that does."""
    if _HANDLED.search(script.text) or script.template:
        return {}
    found: dict[int, Located] = {}
    tested: set[int] = set()
    for block in _top(shell_blocks(script)):
        command = block.command
        if command is None:
            continue
        for word in (*command.words, *command.assignments):
            for number in _numbers(word):
                found.setdefault(number, word)
                if command.name in _TESTS or command.ends in ("||", "&&"):
                    tested.add(number)
    guarded = {
        int(each)
        for each in re.findall(r"\$\{(\d)[:=?+-]|\bcase[ \t]+\"?\$\{?(\d)", script.text)
        for each in each
        if each
    }
    return {number: word for number, word in found.items() if number not in tested | guarded}


def _numbers(word: Located) -> Iterator[int]:
    if _FIELDS.search(word):
        return
    parts = word.stretches() if hasattr(word, "stretches") else [(word, "")]
    for part, quote in parts:
        if quote != "'":
            yield from (int(match["plain"] or match["braced"]) for match in _USED.finditer(part))


def _top(blocks: Sequence[Block]) -> Iterator[Block]:
    """The statements that run in any case: not those of functions and branches."""
    for block in blocks:
        yield block
        if block.kind == "group":
            yield from _top(block.bodies[0])
        elif block.kind == "branches":
            yield from (each for each in block.condition)
