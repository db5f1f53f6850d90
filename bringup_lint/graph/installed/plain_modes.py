"""Files that scripts install with a mode that lets nobody execute them."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from bringup_lint.graph.installed.paths import destination
from bringup_lint.graph.installed.script import Run
from bringup_lint.graph.installed.scripts import Scripts
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

_MODE = regex(r"(?:--mode=|-[bcCDpsTv]*m)(?P<mode>[0-7]*)")
_PLAIN = regex(r"[0-7]?[0246]{3}")
_VALUED = ("-o", "-g", "-S", "--owner", "--group")
_CHANGES = ("chmod", "setfacl")
_NAME = regex(r"[\w.+@-]+")
_LONGEST = 4096
"""No path of Linux is longer."""


class _Changed(NamedTuple):
    """What commands change that give modes."""

    words: set[str]
    names: set[str]
    """The names in these."""
    anywhere: set[Source]
    """The scripts that change files that they do not name."""


def plain_modes(scripts: Scripts) -> dict[str, Located]:
    """The word with the mode, by the path on the robot; none for a file that another command may make executable."""
    found: dict[str, Located] = {}
    executable = set()
    for _, run in scripts.run("install"):
        mode, files = _words(run)
        for path in _targets(files):
            if mode is not None and _PLAIN.fullmatch(mode):
                found[path] = mode
            else:
                executable.add(path)
    changed = _changed(scripts)
    return {
        path: mode for path, mode in found.items() if path not in executable and not _is_changed(path, mode, changed)
    }


def _words(run: Run) -> tuple[Located | None, list[str]]:
    """The mode that ``install`` gives, and the files that it names, without its other options; no files for folders."""
    mode: Located | None = None
    files: list[str] = []
    words = iter(run.words[1:])
    for word in words:
        given = _MODE.fullmatch(word)
        if given is not None:
            mode = word.part(*given.span("mode")) if given["mode"] else next(words, None)
        elif word in _VALUED:
            next(words, None)
        elif re.fullmatch(r"-\w*[dt]\w*|--(?:directory|target-directory.*)", word):
            return mode, []
        elif not word.startswith("-"):
            files.append(run.text(word))
    return mode, files


def _targets(files: list[str]) -> Iterator[str]:
    for source in files[:-1]:
        path = destination(files[-1], posixpath.basename(source), several=len(files) > 2)
        if path is not None and "*" not in path:
            yield path


def _changed(scripts: Scripts) -> _Changed:
    words: set[str] = set()
    names: set[str] = set()
    anywhere: set[Source] = set()
    for source, run in scripts.run(*_CHANGES):
        for word in run.arguments:
            words.add(word)
            names |= {posixpath.basename(word), *_NAME.findall(word)}
            if "*" in word or "{{" in word:
                anywhere.add(source)
    for source, run in scripts.run("find", "xargs"):
        if any(change in word for word in run.words for change in _CHANGES):
            anywhere.add(source)
    return _Changed(words, names, anywhere)


def _is_changed(path: str, mode: Located, changed: _Changed) -> bool:
    """Whether a command may change the mode of a file; one on files that are not named, in the same script only."""
    above = (path[:at] for at, each in enumerate(path[:_LONGEST]) if each == "/")
    return (
        posixpath.basename(path) in changed.names
        or not changed.words.isdisjoint(above)
        or mode.span.source in changed.anywhere
    )
