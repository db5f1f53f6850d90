"""Files that a variable names as a DDS configuration: they are that, whatever they hold."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.dds.selection import PROFILES
from bringup_lint.graph.dds.selection import URI
from bringup_lint.graph.memo import kept
from bringup_lint.parsers.cyclonedds_uri import split_uri
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.files import Files

_VARIABLES = {
    "cyclonedds": (URI,),
    "fastdds": tuple(name for names in PROFILES.values() for name in names),
}
"""Kind of file -> the variables that name one."""
_UNKNOWN_FOLDER = regex(r"^.*(?:\)|\}|\$[A-Za-z_]\w*|^\.{0,2})(?=/)")
"""The folders of a path that only the running system knows."""
LIMIT = 200
"""Values that are followed at most."""
_CHOOSING = regex(r"\.(?:ya?ml|json5?|[ch]pp|cc|cxx|hxx)$")


def is_named(files: Files, kind: str) -> bool:
    """Whether a variable that names a file of the kind appears in the tree."""
    return any(name in source.text for name in _VARIABLES[kind] for source in files.sources)


@kept
def _choices(files: Files) -> list[str]:
    """The lines that may choose a profile by its name."""
    sources = (files.tree.read(path, judged=False) for path in files.tree.like(_CHOOSING)[:LIMIT])
    texts = (source.text for source in sources if source is not None)
    return [line for text in texts for line in text.split("\n") if "profile" in line.lower()]


def is_chosen(files: Files, name: str) -> bool:
    """Whether something of the tree chooses a profile by its name, so that it needs not be the default."""
    whole = re.compile(rf"\b{re.escape(name)}\b")
    for line in (each for each in _choices(files) if name in each):
        for match in whole.finditer(line):
            before = line[max(0, match.start() - 80) : match.start()].lower()
            if "profile" in before and before.rstrip(" \"'").endswith((":", "=", "(", ",")):
                return True
    return False


def named_files(files: Files, ros: RosEnvironment, kind: str, read: Iterable[Source]) -> list[Source]:
    """The files of the tree that something names as a DDS configuration, and that nothing in them shows to be one.
    ``read``: those that a process surely reads."""
    found = {source.name: source for source in read if source.kind != kind}
    settings = [setting for setting in ros.settings if setting.name in _VARIABLES[kind]]
    for setting in settings[:LIMIT]:
        for path in _paths(kind, setting.value):
            source = _file_at(files, path)
            if source is not None and not source.kind:
                found.setdefault(source.name, source)
    return [source for source in found.values() if source.judged and not source.template]


def _paths(kind: str, value: Located) -> Iterator[Located]:
    if kind == "fastdds":
        yield value
        return
    yield from (part.text for part in split_uri(value) if not part.inline)


def _file_at(files: Files, path: Located) -> Source | None:
    """The file at a path, or the only one of the tree with the part of it that is known. What has no ending that a
    configuration has may be anything."""
    known = _UNKNOWN_FOLDER.sub("", path.removeprefix("file://"), count=1)
    if not known.startswith("/") or "$" in known or not known.lower().endswith((".xml", ".conf", ".cfg")):
        return None
    return files.find(known, path.span.source)
