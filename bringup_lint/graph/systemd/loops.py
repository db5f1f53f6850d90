"""How often the loops of a shell script go round, where that can be read."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.model.shell import Block
from bringup_lint.pattern import regex

_SPAN = regex(r"([0-9]+(?:\.[0-9]+)?|\.[0-9]+)([smhd]?)$")
_UNITS = {"": 1.0, "s": 1.0, "m": 60.0, "h": 3600.0, "d": 86400.0}
_VARIABLE = regex(r"\$(?:(\w+)|\{(\w+)(?::?-([^{}]*))?\})$")
_ARRAY = regex(r"\$\{(\w+)\[[@*]\]\}$")
_SEQUENCE = regex(
    r"\$\(\s*seq\s+(?:(\S+)\s+)?(?:(\S+)\s+)?(\S+?)\s*\)$|`\s*seq\s+(?:(\S+)\s+)?(?:(\S+)\s+)?(\S+?)\s*`$"
)
_BRACES = regex(r"\{(\d+)\.\.(\d+)\}$")
_C_LOOP = regex(r"\(\(\s*(\w+)\s*=\s*(\d+)\s*;\s*\w+\s*(<=?)\s*(\$?\{?\w+\}?)\s*;")
_COMPARED = {"-ge": 0, "-gt": 1, "-lt": 0, "-le": 1, "-eq": 0, ">=": 0, ">": 1, "<": 0, "<=": 1, "==": 0}
_ARITHMETIC = regex(r"(?<!\w)\$?\{?(\w+)\}?\s*(>=|<=|==|>|<)\s*(\$?\{?\w+\}?)")
_GROWS = regex(r"(?<!\w)(\w+)\s*(?:\+\+|\+=\s*(\$?\{?\w+\}?)|=\s*\$?\{?\1\}?\s*\+\s*(\$?\{?\w+\}?))|\+\+\s*(\w+)")
_ASSIGNED_SUM = regex(r"(\w+)=\$\(\(\s*\$?\{?(\w+)\}?\s*\+\s*(\$?\{?\w+\}?)\s*\)\)$")
_EXPR_SUM = regex(r"(\w+)=(?:\$\(|`)\s*expr\s+\$\{?(\w+)\}?\s*\+\s*(\S+?)\s*[)`]$")


@dataclass
class Names:
    """What the script has set so far."""

    values: dict[str, str | None] = field(default_factory=dict)
    arrays: dict[str, int] = field(default_factory=dict)
    functions: dict[str, tuple[Block, ...]] = field(default_factory=dict)
    arguments: tuple[str, ...] = ()

    def assign(self, words: Iterable[str]) -> None:
        """Take note of ``NAME=value`` words."""
        for word in words:
            name, _, value = word.partition("=")
            self.values[name.rstrip("+")] = None if name.endswith("+") else value

    def inside(self, arguments: Iterable[str]) -> Names:
        """The names inside a function that is called with these words."""
        return Names(self.values, self.arrays, self.functions, tuple(self.text(word) or "" for word in arguments))

    def text(self, word: str) -> str | None:
        """A word that is literal, a variable, or a variable with a default."""
        match = _VARIABLE.match(word)
        if match is None:
            return None if "$" in word or "`" in word else word
        name = match[1] or match[2]
        if name.isdecimal():
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


def rounds(block: Block, names: Names) -> int:
    """How often a ``for`` goes round; 0 when that is not known."""
    return max(sum(_values_of(str(item), names) for item in block.items), 0)


def _values_of(item: str, names: Names) -> int:
    """How many values a word of a ``for`` stands for."""
    if not item or item in ("$@", "$*"):
        return len(names.arguments)
    if match := _C_LOOP.match(item):
        end = names.number(match[4])
        return int(end - int(match[2]) + (match[3] == "<=")) if end is not None else 0
    if match := _ARRAY.match(item):
        return names.arrays.get(match[1], 0)
    if match := _BRACES.match(item):
        return abs(int(match[2]) - int(match[1])) + 1
    if match := _SEQUENCE.match(item):
        first, step, last = match.group(1, 2, 3) if match[3] else match.group(4, 5, 6)
        return _sequence(*(names.number(word) if word else 1.0 for word in (first, step, last)))
    if match := _VARIABLE.match(item):
        text = names.text(item)
        return len(text.split()) if text else 0
    return 0 if "$" in item or "`" in item or "*" in item else 1


def _sequence(first: float | None, step: float | None, last: float | None) -> int:
    """How many numbers ``seq`` writes."""
    if first is None or last is None or not step:
        return 0
    return int((last - first) / step) + 1


def flat(found: Iterable[Block]) -> Iterator[Block]:
    """The blocks that every round of a loop goes through, inner loops left out."""
    for block in found:
        if block.kind in ("for", "loop", "function"):
            continue
        yield block
        yield from flat((*block.condition, *(inner for body in block.bodies for inner in body)))


def raised_in(found: list[Block], names: Names) -> Iterator[tuple[str, float]]:
    """Variables that every round raises, and by how much."""
    for block in found:
        texts: list[str] = [block.arithmetic] if block.arithmetic else []
        command = block.command
        if command is not None:
            yield from _assigned_sums(command.assignments, names)
            if command.name in ("let", ":"):
                texts += [word.removeprefix("$((").removesuffix("))") for word in command.words[1:]]
        for text in texts:
            if match := _GROWS.search(text):
                step = match[2] or match[3]
                number = names.number(step) if step else 1.0
                if number:
                    yield match[1] or match[4], number


def _assigned_sums(assignments: Iterable[str], names: Names) -> Iterator[tuple[str, float]]:
    """``n=$((n + 1))`` and ``n=$(expr $n + 1)``."""
    for word in assignments:
        match = _ASSIGNED_SUM.match(word) or _EXPR_SUM.match(word)
        step = names.number(match[3]) if match and match[1] == match[2] else None
        if match and step:
            yield match[1], step


def limits_in(found: list[Block], names: Names) -> Iterator[tuple[str, float, int]]:
    """(variable, limit, 1 when it must be exceeded): comparisons that end the loop."""
    for block in found:
        for compared in _ARITHMETIC.finditer(block.arithmetic or ""):
            limit = names.number(compared[3])
            if limit is not None:
                yield compared[1], limit, _COMPARED[compared[2]]
        if block.command is None or block.command.name not in ("[", "[[", "test"):
            continue
        words = block.command.words
        for at, word in enumerate(words[1:-1], 1):
            variable = _VARIABLE.match(words[at - 1]) if word in _COMPARED else None
            limit = names.number(words[at + 1]) if variable else None
            if variable and limit is not None:
                yield variable[1] or variable[2], limit, _COMPARED[str(word)]
