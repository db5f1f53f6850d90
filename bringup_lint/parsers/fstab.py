"""fstab(5): fields separated by blanks, octal escapes, lines that begin with # are comments."""

from __future__ import annotations

from bringup_lint.model.fstab import Fstab
from bringup_lint.model.fstab import Mount
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_LINE = regex(r"[^\n]+")
_ESCAPE = regex(r"\\([0-3][0-7]{2})")


def parse(source: Source) -> Fstab:
    """Read the lines. Nothing is refused; lines with too few fields keep what they have."""
    fstab = Fstab(source)
    for match in _LINE.finditer(source.text):
        line = source.located(*match.span()).strip_located()
        if line and not line.startswith("#"):
            fstab.mounts.append(_mount(line))
    return fstab


def _mount(line: Located) -> Mount:
    fields = tuple(_fields(line))
    rest = (*fields, None, None, None, None, None, None)
    options = tuple(_parts(rest[3])) if rest[3] is not None else ()
    return Mount(fields, fields[0], _plain(rest[1]), rest[2], options, rest[5])


def _fields(line: Located) -> list[Located]:
    """The fields; a comment is one only behind the sixth."""
    fields: list[Located] = []
    for word in line.words():
        if word.startswith("#") and len(fields) >= 6:
            break
        fields.append(word)
    return fields


def _plain(word: Located | None) -> Located | None:
    if word is None or "\\" not in word:
        return word
    return Located(_ESCAPE.sub(lambda match: chr(int(match[1], 8)), word), word.span)


def _parts(options: Located) -> list[Located]:
    found, start = [], 0
    for part in options.split(","):
        found.append(options.part(start, start + len(part)))
        start += len(part) + 1
    return [option for option in found if option]
