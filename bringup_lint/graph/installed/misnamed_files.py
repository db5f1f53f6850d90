"""Files that a script names in another spelling than the tree: `Ros.sh` for `ros.sh`, `map_server.yaml` for
`map-server.yaml`."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.installed.script import Run
from bringup_lint.graph.installed.script_files import GENERATED
from bringup_lint.graph.installed.script_files import read_words
from bringup_lint.graph.installed.scripts import Scripts
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_SENDS = ("scp", "rsync")
_NAME = regex(r"[A-Za-z0-9_+-][A-Za-z0-9_.+-]*\.[A-Za-z][A-Za-z0-9]*")
_BETWEEN = regex(r"[-_. ]")
_PAGE = regex(r"(?:^|/)(?:[Mm]akefile|justfile|Dockerfile)[^/]*$|\.mk$")
_MOST_OF_PAGE = 100_000


class Misnamed(NamedTuple):
    word: Located
    name: str
    there: str
    """The path of the file that is meant."""


def misnamed_files(scripts: Scripts, sources: Iterable[Source]) -> Iterator[Misnamed]:
    """The files that scripts read and of which the tree has the name in another spelling only."""
    spellings = _spellings(scripts.files.tree.paths)
    for source in sources:
        for name, uses in _named(scripts, source).items():
            others = spellings.get(_folded(name), ()) if _NAME.fullmatch(name) else ()
            if len({posixpath.basename(each) for each in others}) != 1 or name in map(posixpath.basename, others):
                continue
            for word, path in uses:
                there = next((each for each in others if _is_in(scripts, path, each)), None)
                if there is not None and not _may_exist(scripts, source, path, len(uses)):
                    yield Misnamed(word, name, there)


def _named(scripts: Scripts, source: Source) -> dict[str, list[tuple[Located, str]]]:
    """The files that a script reads: their names, with each word and the path that it gives."""
    found: dict[str, list[tuple[Located, str]]] = {}
    runs = (did for did in scripts.done(source) if isinstance(did, Run))
    read = ((did.text(word), word) for did in runs for word in _words(did))
    for path, word in read:
        found.setdefault(posixpath.basename(path), []).append((word, path))
    return found


def _words(run: Run) -> Iterator[Located]:
    yield from read_words(run)
    if run.name in _SENDS:
        yield from (word for word in run.words[1:-1] if not word.startswith("-") and ":" not in word)


def _folded(name: str) -> str:
    """What the spellings of a name have in common."""
    stem, ending = posixpath.splitext(name.lower())
    return _BETWEEN.sub("-", stem) + (".yaml" if ending == ".yml" else ending)


def _spellings(paths: Iterable[str]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for path in paths:
        found.setdefault(_folded(posixpath.basename(path)), []).append(path)
    return found


def _is_in(scripts: Scripts, path: str, there: str) -> bool:
    """Whether a path may lead to the folder of a file: it says no folder, one of the same name, or one of the robot to
    which something copies the file."""
    folder = posixpath.dirname(path)
    if folder.startswith("/"):
        return _is_copied_to(scripts, posixpath.basename(there), folder)
    last = posixpath.basename(folder)
    return last in ("", ".", "..") or "{{" in last or last == posixpath.basename(posixpath.dirname(there))


def _is_copied_to(scripts: Scripts, name: str, folder: str) -> bool:
    copied = re.compile(
        rf"(?<![\w.-]){re.escape(name)}\b[^\n]{{0,200}}{re.escape(folder)}/?(?:[\s\"']|{re.escape(name)}|$)", re.M
    )
    pages = scripts.files.tree.pages(_PAGE, _MOST_OF_PAGE)
    return scripts.files.mentions(copied) or any(map(copied.search, pages))


def _may_exist(scripts: Scripts, source: Source, path: str, uses: int) -> bool:
    """Whether something else than these commands speaks of the file, so that it may make it."""
    tree = scripts.files.tree
    name = posixpath.basename(path)
    if GENERATED.search(path) or tree.is_ignored(name) or tree.is_ignored(path):
        return True
    said = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w-])")
    if len(said.findall(source.uncommented)) > uses:
        return True
    others = (other for other in scripts.files.sources if other is not source and name in other.text)
    return any(said.search(other.uncommented) for other in others)
