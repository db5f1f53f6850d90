"""Patterns as in gitignore(5), matched in time that grows linearly with pattern and path.

A pattern of a tree is not trusted, and the regular expressions that libraries make of them backtrack: ``*a*a*a*b``
takes time that doubles with each star.
"""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Sequence

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.pattern import regex

Matches = Callable[[str], bool]
_CLASSES: dict[str, Matches] = {
    "alnum": str.isalnum,
    "alpha": str.isalpha,
    "digit": str.isdecimal,
    "lower": str.islower,
    "space": str.isspace,
    "upper": str.isupper,
}
_ANY_FOLDERS = "**"


_SPECIAL = regex(r"[\\*?\[\]]|^[!#]| $")


def escaped(path: str) -> str:
    """The pattern that means just this path."""
    return _SPECIAL.sub(lambda match: f"\\{match[0]}", path)


class PatternError(ValueError):
    """A pattern that git takes for none; it matches nothing."""


@dataclass(frozen=True)
class _Segment:
    """What one name of a path must be: between stars, runs of characters."""

    runs: tuple[tuple[Matches, ...], ...]

    def matches(self, name: str) -> bool:
        first, *others = self.runs
        if not _fits(first, name, 0):
            return False
        at = len(first)
        if not others:
            return at == len(name)
        for run in others[:-1]:
            found = next((start for start in range(at, len(name)) if _fits(run, name, start)), None)
            if found is None:
                return False
            at = found + len(run)
        last = len(name) - len(others[-1])
        return last >= at and _fits(others[-1], name, last)


@dataclass(frozen=True)
class _Pattern:
    parts: tuple[tuple[Matches, ...], ...]
    """Runs of names; between them are any number of folders."""
    folder_only: bool
    includes: bool
    below: bool
    """Whether it means all that lies below, and not the folder itself (``a/**``)."""

    def matches(self, names: Sequence[str], is_folder: bool) -> bool:
        if self.folder_only and not is_folder:
            return False
        return _in_order(self.parts, names[:-1], open_end=True) if self.below else _in_order(self.parts, names)


@dataclass(eq=False)
class Patterns:
    """The patterns of one file, from first to last."""

    patterns: tuple[_Pattern, ...]
    _folders: dict[str, bool] = field(default_factory=dict)

    @classmethod
    def of(cls, lines: Iterable[str]) -> Patterns:
        """Patterns that git takes for none are left out."""
        found = []
        for line in lines:
            try:
                found.append(pattern_of(line))
            except PatternError:
                continue
        return cls(tuple(each for each in found if each is not None))

    def match(self, path: str) -> bool:
        """Whether a path, relative to the patterns, is left out, or a folder above it; a folder ends in ``/``."""
        is_folder = path.endswith("/")
        names = path.strip("/").split("/")
        if len(names) > 1 and self._leaves_out("/".join(names[:-1])):
            return True
        return self._decides(names, is_folder)

    def _leaves_out(self, folder: str) -> bool:
        known = self._folders
        names = folder.split("/")
        for count in range(1, len(names) + 1):
            path = "/".join(names[:count])
            if path not in known:
                known[path] = self._decides(names[:count], is_folder=True)
            if known[path]:
                return True
        return False

    def _decides(self, names: Sequence[str], is_folder: bool) -> bool:
        """What the last pattern says that matches."""
        for pattern in reversed(self.patterns):
            if pattern.matches(names, is_folder):
                return not pattern.includes
        return False


def pattern_of(line: str) -> _Pattern | None:
    """The pattern in a line; None for a comment or an empty line. Raises PatternError."""
    text = _without_trailing_blanks(line)
    if not text or text.startswith("#"):
        return None
    includes = text.startswith("!")
    text = text[includes:]
    folder_only = text.endswith("/")
    text = text.removesuffix("/")
    if not text:
        raise PatternError(f"'{line}' names nothing")
    names = _names(text.removeprefix("/"))
    if "/" not in text:
        names.insert(0, _ANY_FOLDERS)
    below = len(names) > 1 and names[-1] == _ANY_FOLDERS
    parts: list[list[Matches]] = [[]]
    for name in names[:-1] if below else names:
        if name == _ANY_FOLDERS:
            parts.append([])
        else:
            parts[-1].append(_segment(name))
    return _Pattern(tuple(map(tuple, parts)), folder_only, includes, below)


def _without_trailing_blanks(line: str) -> str:
    text = line.rstrip("\r\n").rstrip(" ")
    escaped = (len(text) - len(text.rstrip("\\"))) % 2 and len(text) < len(line.rstrip("\r\n"))
    return text + " " if escaped else text


def _names(text: str) -> list[str]:
    """The parts of a pattern between slashes; one in brackets is no end. Raises PatternError."""
    found, at = [""], 0
    while at < len(text):
        end = at + 1
        if text[at] == "[":
            end = _class(text, at + 1)[1]
        elif text[at] == "\\" and text[end : end + 1] not in ("", "/"):
            end += 1
        if text[at] == "/":
            found.append("")
        else:
            found[-1] += text[at:end]
        at = end
    return found


def _segment(text: str) -> Matches:
    if not any(char in text for char in "*?[\\"):
        return text.__eq__
    runs: list[list[Matches]] = [[]]
    at = 0
    while at < len(text):
        char = text[at]
        at += 1
        if char == "*":
            runs.append([])
        elif char == "?":
            runs[-1].append(_anything)
        elif char == "[":
            matches, at = _class(text, at)
            runs[-1].append(matches)
        else:
            if char == "\\":
                if at == len(text):
                    raise PatternError(f"'{text}' ends with a backslash")
                char = text[at]
                at += 1
            runs[-1].append(char.__eq__)
    return _Segment(tuple(map(tuple, runs))).matches


def _anything(char: str) -> bool:
    return True


def _class(text: str, at: int) -> tuple[Matches, int]:
    """The characters in brackets, and where they end. Raises PatternError."""
    outside = text[at : at + 1] in ("!", "^")
    start = at = at + outside
    named: list[Matches] = []
    ranges: list[tuple[str, str]] = []
    while True:
        char = text[at : at + 1]
        if not char:
            raise PatternError(f"'{text}' has a bracket without its end")
        if char == "]" and at > start:
            break
        if text.startswith("[:", at) and (end := text.find(":]", at)) > 0:
            if text[at + 2 : end] not in _CLASSES:
                raise PatternError(f"'{text}' names an unknown class")
            named.append(_CLASSES[text[at + 2 : end]])
            at = end + 2
            continue
        low, at = _literal(text, at)
        high = low
        if text[at : at + 1] == "-" and text[at + 1 : at + 2] not in ("", "]"):
            high, at = _literal(text, at + 1)
        ranges.append((low, high))

    def matches(char: str) -> bool:
        inside = any(low <= char <= high for low, high in ranges) or any(test(char) for test in named)
        return inside != outside

    return matches, at + 1


def _literal(text: str, at: int) -> tuple[str, int]:
    """A character, which a backslash may precede, and where it ends."""
    at += text[at] == "\\" and at + 1 < len(text)
    return text[at], at + 1


def _in_order(parts: Sequence[Sequence[Matches]], names: Sequence[str], open_end: bool = False) -> bool:
    """Whether the runs come in this order: the first at the start, the last at the end unless that is open."""
    first, *others = parts
    if not _fits(first, names, 0):
        return False
    at = len(first)
    if not others:
        return open_end or at == len(names)
    for run in others if open_end else others[:-1]:
        found = next((start for start in range(at, len(names) + 1) if _fits(run, names, start)), None)
        if found is None:
            return False
        at = found + len(run)
    last = len(names) - len(others[-1])
    return open_end or (last >= at and _fits(others[-1], names, last))


def _fits(run: Sequence[Matches], items: Sequence[str], start: int) -> bool:
    """Whether the items from ``start`` on are what a run asks for."""
    if start + len(run) > len(items):
        return False
    return all(matches(items[start + number]) for number, matches in enumerate(run))
