"""Paths in values: absolute or relative, without ``..``, alone or in lists with prefixes and options."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.dataclass import replace
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import UNIT
from bringup_lint.parsers.systemd_values.problems import WORD
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.parsers.systemd_values.specifiers import check_specifiers
from bringup_lint.parsers.systemd_values.specifiers import literal
from bringup_lint.parsers.systemd_values.specifiers import specifiers
from bringup_lint.parsers.systemd_values.word_splitting import BLANKS
from bringup_lint.parsers.systemd_values.word_splitting import DECODE
from bringup_lint.parsers.systemd_values.word_splitting import DROP
from bringup_lint.parsers.systemd_values.word_splitting import KEEP
from bringup_lint.parsers.systemd_values.word_splitting import extract
from bringup_lint.parsers.systemd_values.word_splitting import split_words
from bringup_lint.source import Located

ABSOLUTE = "an absolute path"
RELATIVE = "a path relative to the base folder"


def is_absolute(text: str) -> bool | None:
    """Whether the path starts at the root; None when that hangs on a specifier."""
    if text.startswith("%") and text[1:2].isalnum():
        known = specifiers().get(text[1:2])
        return True if known is not None and known.expands == "path" else None
    return text.startswith("/")


def check_path(
    path: Located, version: int, effect: str = LINE, *, absolute: bool | None = True
) -> Iterator[ValueProblem]:
    """One path. ``absolute``: what it has to be, None for either."""
    bad = list(check_specifiers(path, version, effect))
    yield from bad
    if bad:
        return
    is_so = is_absolute(path)
    if absolute and is_so is False:
        yield ValueProblem("not-absolute", path, ABSOLUTE, effect)
    elif absolute is False and is_so:
        yield ValueProblem("not-relative", path, RELATIVE, effect)
    elif ".." in path.split("/") or path.strip("/") == ".":
        yield ValueProblem("not-normalized", path, "a path without '..'", effect)


def check_path_fatal(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_path(value, version, UNIT)


def check_working_directory(value: Located, version: int) -> Iterator[ValueProblem]:
    """``~``, or an absolute path; with ``-`` in front a bad one costs the line only."""
    optional = value.startswith("-")
    path = value.part(1, len(value)) if optional else value
    if path != "~":
        yield from check_path(path, version, LINE if optional else UNIT)


def check_environment_file(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_path(value.part(1, len(value)) if value.startswith("-") else value, version)


def check_pid_file(value: Located, version: int) -> Iterator[ValueProblem]:
    """A relative path is taken below /run; one with ``..`` stops the unit."""
    for problem in check_path(value, version, absolute=None):
        yield replace(problem, effect=UNIT) if problem.code == "not-normalized" else problem


def check_condition_path(value: Located, version: int) -> Iterator[ValueProblem]:
    start = 0
    for mark in "|!":
        start += value.startswith(mark, start)
    yield from check_path(value.part(start, len(value)), version)


def check_paths(value: Located, version: int) -> Iterator[ValueProblem]:
    """A list of absolute paths, each with ``-`` and ``+`` in front as wanted."""
    found = split_words(value)
    yield from found.problems
    for word in found.words:
        start = int(word.startswith("-"))
        start += word.startswith("+", start)
        yield from check_path(word.part(start, len(word)), version, WORD)


def check_mounts_for(value: Located, version: int) -> Iterator[ValueProblem]:
    found = split_words(value)
    yield from found.problems
    for word in found.words:
        yield from check_path(word, version, WORD)


def check_colon_paths(value: Located, version: int) -> Iterator[ValueProblem]:
    found = split_words(value, separators=":", quotes=False, coalesce=False)
    yield from found.problems
    for word in found.words:
        yield from check_path(word, version)


def check_directories(value: Located, version: int, *, links: bool = True) -> Iterator[ValueProblem]:
    """RuntimeDirectory= and its kin: relative paths, from 252 on with ``:LINK``."""
    found = split_words(value, escapes=KEEP)
    yield from found.problems
    for item in found.words:
        escapes = DROP if "\\:" in item else DECODE
        parts = split_words(item, separators=":", quotes=False, escapes=escapes)
        if parts.broken or not parts.words:
            yield ValueProblem("invalid", item, RELATIVE)
            return
        for part in parts.words[:2]:
            yield from check_path(part, version, WORD, absolute=False)
        if parts.words[0].split("/")[0] == "private":
            yield ValueProblem("invalid", item, "a folder that is not below 'private'", WORD)
        if len(parts.words) > 1 and not links:
            yield ValueProblem("invalid", item, "a folder without a link name", WORD)


def check_plain_directories(value: Located, version: int) -> Iterator[ValueProblem]:
    yield from check_directories(value, version, links=False)


def check_bind_paths(value: Located, version: int) -> Iterator[ValueProblem]:
    """``SOURCE[:DESTINATION[:rbind|norbind]]``, both absolute."""
    at = 0
    while at >= 0:
        source = extract(value, at, separators=":" + BLANKS, escapes="drop", coalesce=False)
        at = source.next
        if source.word is None or source.broken:
            yield from source.problems
            return
        path = source.word.part(1, len(source.word)) if source.word.startswith("-") else source.word
        if not path and not source.word:
            if at < 0:
                return
            if value[at - 1] in BLANKS:
                continue
        bad = list(check_path(path, version, WORD))
        yield from bad
        if bad or at < 0 or value[at - 1] != ":":
            continue
        target = extract(value, at, separators=":" + BLANKS, escapes="drop", coalesce=False)
        at = target.next
        if target.word is None or target.broken:
            yield from target.problems
            return
        bad = list(check_path(target.word, version, WORD))
        yield from bad
        if bad or at < 0 or value[at - 1] != ":":
            continue
        options = extract(value, at, escapes="drop")
        at = options.next
        if options.word is not None and options.word not in ("", "rbind", "norbind"):
            yield ValueProblem("invalid", options.word, "rbind or norbind", WORD)


def check_temporary_file_systems(value: Located, version: int) -> Iterator[ValueProblem]:
    """``PATH[:OPTIONS]``."""
    found = split_words(value)
    yield from found.problems
    for word in found.words:
        path = word.part(0, word.find(":")) if ":" in word else word
        yield from check_path(path, version, WORD)


def check_open_file(value: Located, version: int) -> Iterator[ValueProblem]:
    """``PATH[:NAME[:OPTIONS]]``."""
    path = value.part(0, value.find(":")) if ":" in value else value
    yield from check_path(path, version)


def _is_device(node: str) -> bool:
    if node.startswith(("block-", "char-")):
        return True
    return f"{node}/".startswith(("/dev/", "/run/systemd/inaccessible/")) and ".." not in node.split("/")


def check_device_allow(value: Located, version: int) -> Iterator[ValueProblem]:
    """A node below /dev, ``char-NAME`` or ``block-NAME``, then the rights out of ``rwm``."""
    found = extract(value, escapes="drop")
    if found.word is None or found.broken:
        yield ValueProblem("invalid", value, "a device node and rights such as rw")
        return
    bad = list(check_specifiers(found.word, version))
    yield from bad
    if bad:
        return
    node = literal(found.word)
    expected = "a device node below /dev, char-NAME or block-NAME"
    if node is not None and not _is_device(node):
        yield ValueProblem("invalid", found.word, expected)
    elif found.next >= 0:
        rights = value.part(found.next, len(value))
        if rights.strip("rwm"):
            yield ValueProblem("invalid", rights, "rights out of r, w and m")
