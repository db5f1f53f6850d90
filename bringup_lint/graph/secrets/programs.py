"""Secrets in the sources of nodes and in scripts: names that say so, set to a literal that looks like one."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files

MODULES = 2_000
"""Python modules of one tree that are read besides its nodes."""
TEXT = 500_000
"""Code points of such a module."""
_LAUNCH = regex(r"[._-]launch\.py$|/launch/|/(?:setup|conftest)\.py$")
_LITERAL = r"""(?P<quote>["'])(?P<value>[^\s"'\\]{8,200})(?P=quote)"""
_PATTERNS = {
    "python-node": (
        regex(r"(?<![\w\"'])(?P<name>[A-Za-z_]\w*)[ \t]*(?::[ \t]*str[ \t]*)?=[ \t]*" + _LITERAL),
        regex(r"""["'](?P<name>[A-Za-z_]\w*)["'][ \t]*[:,][ \t]*""" + _LITERAL),
    ),
    "shell-script": (
        regex(r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=" + _LITERAL, re.M),
        regex(r"^[ \t]*(?:export[ \t]+)?(?P<name>[A-Za-z_]\w*)=(?P<value>[^\s\"'$`;&|()<>\\]{8,200})[ \t]*$", re.M),
    ),
}
_LOOKS_DRAWN = regex(r"(?=.*[0-9])(?=.*[A-Za-z])[\w+/=.!@#^*:-]+$")
_TEST = regex(r"(?:^|/)(?:tests?|examples?|samples?)/|(?:^|/)(?:test_[^/]*|[^/]*_test)\.")


class Assigned(NamedTuple):
    """A name and the literal that a program gives it."""

    name: str
    value: Located


def assigned(files: Files) -> Iterator[Assigned]:
    """What the judged programs set to a literal with letters and digits: words of a language are not secrets."""
    for kind, patterns in _PATTERNS.items():
        for source in files.of_kind(kind):
            if source.judged and not _TEST.search(source.name):
                yield from _in(source, patterns)
    for source in _modules(files):
        yield from _in(source, _PATTERNS["python-node"])


def _in(source: Source, patterns: tuple[re.Pattern[str], ...]) -> Iterator[Assigned]:
    for match in (match for pattern in patterns for match in pattern.finditer(source.text)):
        if _LOOKS_DRAWN.match(match["value"]):
            yield Assigned(match["name"], source.located(*match.span("value")))


def _modules(files: Files) -> Iterator[Source]:
    """The Python modules of the packages of the tree that are neither nodes nor launch files."""
    known = {os.path.abspath(source.name) for source in files.sources}
    folders = {os.path.dirname(os.path.abspath(source.name)) for source in files.of_kind("ros-package")}
    paths = (path for path in sorted(files.tree.paths) if path.endswith(".py") and path not in known)
    for path in islice((path for path in paths if _is_below(path, folders)), MODULES):
        source = files.tree.read(path) if not _TEST.search(path) and not _LAUNCH.search(path) else None
        if source is not None and source.judged and len(source.text) <= TEXT:
            yield source


def _is_below(path: str, folders: set[str]) -> bool:
    folder = os.path.dirname(path)
    while len(folder) > 1 and folder not in folders:
        folder = os.path.dirname(folder)
    return folder in folders
