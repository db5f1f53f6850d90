"""The lines of interface definitions that rosidl refuses (rosidl_adapter, ``parser.py``), and the types of others."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

PRIMITIVE = frozenset(
    "bool byte char float32 float64 int8 uint8 int16 uint16 int32 uint32 int64 uint64 string wstring".split()
) | {"duration", "time"}
_TEXTS = regex(r"w?string<=0*[1-9]\d*\Z")
_ARRAY = regex(r"(?P<of>[^\[\]]*)\[(?:(?:<=)?0*[1-9]\d*)?\]\Z")
_PACKAGE = regex(r"(?!.*__)(?!.*_\Z)[a-z][a-z0-9_]*\Z")
"""Also the name of a field."""
_MESSAGE = regex(r"(?:Sample_)?[A-Z][A-Za-z0-9]*(?:_(?:Request|Response|Goal|Result|Feedback))*\Z")
_CONSTANT = regex(r"[A-Z](?:_?[A-Z0-9])*\Z")
_SEPARATOR = "---"
SEPARATORS = {"srv": 1, "action": 2}


class FieldType(NamedTuple):
    """The message that a field has as its type."""

    name: Located
    """As it is written, without the brackets of an array."""
    package: str
    """Empty for one of the same package."""
    message: str


class InterfaceLines(NamedTuple):
    problems: list[Problem]
    types: list[FieldType]


def parse(source: Source) -> InterfaceLines:
    """Problem codes: ``no-name``, ``type``, ``array``, ``field-name``, ``constant-type``, ``constant-name``, ``twice``
    and ``separators``."""
    found = InterfaceLines([], [])
    names: set[str] = set()
    for line in _lines(source):
        if line.strip() == _SEPARATOR:
            names = set()
            continue
        words = re.match(r"([^ \t]+)[ \t]+([^ \t=]+)[ \t]*(=?)", line)
        if words is None:
            if not line.startswith((" ", "\t")) and "=" not in line:
                found.problems.append(Problem("no-name", line.strip_located()))
            continue
        kind, name = line.part(*words.span(1)), line.part(*words.span(2))
        # A name that a default or comment follows ends at a blank, so that a later "=" makes a constant of any line.
        is_constant = "=" in line[words.end(1) :]
        found.problems.extend(_of_constant(kind, name) if is_constant else _of_field(kind, name))
        if name in names:
            found.problems.append(Problem("twice", name))
        names.add(str(name))
        bare = kind.part(0, len(kind.partition("[")[0]))
        package, _, message = bare.rpartition("/")
        if not is_constant and _MESSAGE.match(message):
            found.types.append(FieldType(bare, str(package), str(message)))
    wanted = SEPARATORS.get(source.name.rpartition(".")[2])
    if wanted is not None and source.text.splitlines().count(_SEPARATOR) != wanted:
        found.problems.append(Problem("separators", source.whole))
    return found


def _lines(source: Source) -> Iterator[Located]:
    """Those with a field, a constant or a separator, without their comments."""
    text, start = source.text, 0
    for whole in text.splitlines(keepends=True):
        said = whole.partition("#")[0].rstrip()
        if said.strip():
            yield Located(said, source.span(start, start + len(said)))
        start += len(whole)


def _of_constant(kind: Located, name: Located) -> Iterator[Problem]:
    if kind not in PRIMITIVE:
        yield Problem("constant-type", kind)
    elif not _CONSTANT.match(name):
        yield Problem("constant-name", name)


def _of_field(kind: Located, name: Located) -> Iterator[Problem]:
    bare = kind
    if kind.endswith("]"):
        array = _ARRAY.match(kind)
        if array is None:
            yield Problem("array", kind)
            return
        bare = kind.part(*array.span("of"))
    if bare not in PRIMITIVE and not _TEXTS.match(bare) and not _is_message(bare):
        yield Problem("type", bare)
    elif not _PACKAGE.match(name):
        yield Problem("field-name", name)


def _is_message(kind: str) -> bool:
    package, slash, message = kind.partition("/")
    return bool(_PACKAGE.match(package) and _MESSAGE.match(message) if slash else _MESSAGE.match(kind))
