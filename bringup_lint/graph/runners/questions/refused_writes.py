"""What services of a user change in folders that belong to root."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.folders import above
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.installed.script import Run
from bringup_lint.graph.systemd.directories import directories
from bringup_lint.graph.systemd.provision import naming
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.installed.scripts import Scripts
    from bringup_lint.graph.systemd.filesystem import Filesystem
    from bringup_lint.graph.systemd.process import Process
    from bringup_lint.graph.systemd.unit import Unit

_OF_ROOT = regex(r"/(?:etc|boot|usr(?:/local)?/(?:s?bin|lib|share|etc))/[^{}$*]+")
_FOLDERS = regex(r"/var/(?:log|lib|cache|spool)/[^{}$*]+")
"""Where only root may make files and folders, and others get theirs."""
_TO_LAST = ("cp", "mv", "ln", "install")
_TO_ALL = ("tee", "mkdir", "touch", "rm", "rmdir", "chmod", "chown")
_MAKERS = ("mkdir", "touch", "tee")
_FORCED = regex(r"-\w*f\w*|--force")
"""``rm -f``, which does nothing where the file is not there."""
_PARENTS = regex(r"-\w*p\w*|--parents")
_PYTHON = regex(r"python[0-9.]*")
_POWERS = ("AmbientCapabilities", "CapabilityBoundingSet", "PAMName", "RootDirectory", "BindPaths", "ReadWritePaths")
_GIVES = r"\b(?:chown|chmod|setfacl|chgrp|install|mode|owner)\b"
_MOST = 100_000


class _Change(NamedTuple):
    where: Located | Span
    path: str
    may_be_there: bool = False
    """``mkdir -p``, which does nothing where the folder is there."""


class RefusedWrite(NamedTuple):
    unit: Unit
    user: Located
    where: Located | Span
    path: str


def refused_writes(filesystem: Filesystem, scripts: Scripts) -> Iterator[RefusedWrite]:
    """What the scripts and Python programs of services surely change, and their users may not; nothing where another
    file of the tree names the file or folder, or one that it lies in."""
    for unit in filesystem.units.services:
        user = unit.identity.user
        if user is None or not unit.identity.is_other or any(unit.has(key) for key in _POWERS) or unit.uncertain:
            continue
        for process in filesystem.units.processes(unit):
            if process.prefixes.strip("-@:") or process.key == "ExecStopPost":
                continue
            for place, path, may_be_there in _changed(process, filesystem.files, scripts):
                if not _is_given(filesystem, unit, path, place, by_name=may_be_there):
                    yield RefusedWrite(unit, user, place, path)


def _changed(process: Process, files: Files, scripts: Scripts) -> Iterator[_Change]:
    """What a command line surely changes."""
    for source in dict.fromkeys(step.script for step in process.steps if step.script is not None):
        if not scripts.raises_itself(source):
            yield from _by_shell(scripts, source)
    for step in process.steps:
        words = unwrapped(step.command.words)
        if words and step.command.depth == 0:
            name = program_name(words[0])
            program = next((word for word in words[1:] if not word.startswith("-")), None)
            at = program if _PYTHON.fullmatch(name) else words[0] if words[0].endswith(".py") else None
            run_by = files.find(at, at.span.source) if at is not None and at.startswith("/") else None
            if run_by is not None and run_by.name.endswith(".py") and len(run_by.text) < _MOST:
                from bringup_lint.graph.runners.questions.python_writes import python_writes

                yield from (_Change(place, path) for place, path in python_writes(run_by) if _is_of_root(path))


def _is_of_root(path: str) -> bool:
    return _FOLDERS.fullmatch(path) is not None or _OF_ROOT.fullmatch(path) is not None


def _by_shell(scripts: Scripts, source: Source) -> Iterator[_Change]:
    for did in scripts.done(source):
        if not isinstance(did, Run):
            if did.by_shell and did.certain and not did.refused and _OF_ROOT.fullmatch(did.path):
                yield _Change(did.where, did.path)
            continue
        if did.by_root or not did.certain or did.command.hides_errors or did.command.ends in ("||", "&&"):
            continue
        named = [word for word in did.words[1:] if not word.startswith("-")]
        changed = named[-1:] if did.name in _TO_LAST else named if did.name in _TO_ALL else []
        if did.name == "rm" and any(map(_FORCED.fullmatch, did.words)):
            continue
        may_be_there = did.name == "mkdir" and any(map(_PARENTS.fullmatch, did.words))
        for word in changed:
            path = did.text(word)
            if _OF_ROOT.fullmatch(path) or (did.name in _MAKERS and _FOLDERS.fullmatch(path)):
                yield _Change(did.words[0], path, may_be_there)
                break


def _is_given(filesystem: Filesystem, unit: Unit, path: str, place: Located | Span, *, by_name: bool) -> bool:
    """Whether something else makes the file or folder, or gives it to the user; for what may be there already, whether
    something else names it."""
    own = {path.rstrip("/"), *(each for each in above(path) if each.count("/") > 1 + (not each.startswith("/etc/")))}
    if any(made.rstrip("/") in own for each in filesystem.units.all for made in directories(each)):
        return True
    source = (place.span if isinstance(place, Located) else place).source
    pattern = "|".join(re.escape(each) + r"(?![\w-])" for each in own)
    gives = re.compile(rf"{_GIVES}[^\n]*(?:{pattern})" if _OF_ROOT.fullmatch(path) and not by_name else pattern)
    files = filesystem.files
    others = [each for each in files.sources if each is not source and gives.search(each.text)]
    others += filter(None, map(files.tree.at, naming(files.tree, gives)))
    return any(each.name != source.name and files.same_robot(each, unit.files[0].source) for each in others)
