"""Programs of Exec lines that systemd cannot start: status 203/EXEC."""

from __future__ import annotations

import re
from collections.abc import Iterator
from enum import Enum

from bringup_lint.graph.files import Files
from bringup_lint.graph.systemd.filesystem import Filesystem
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.provision import scripts_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.templates import final_name

OF_NO_PACKAGE = regex(
    r"/(?:usr/local|opt|etc|home|root|srv|var|data)/.+", hints="local/ opt/ etc/ home/ root/ srv/ var/ data/"
)
"""Where programs lie that no package of the distribution brings."""
_MODE = regex(r"^[ \t-]*(?:permissions|mode)[\"']?[ \t]*:", re.M)
_CHANGES = regex(r"\b(?:chmod|setfacl|install|cp|mv|rsync)\b[^\n]*")
_GIVES_MODE = regex(r"\b(?:chmod|setfacl|install[ \t]|rsync[^\n]{0,200}--chmod)[^\n]*")
_ITEMS = regex(r"fileglob|\{\{[ \t]*item|\bsrc:[^\n]{0,200}/[\"']?[ \t]{0,9}$", re.M)
"""Names of several files in a task."""
_SEVERAL = regex(r"[*$]|\{\}|[ \t]-\w{0,5}R")


class Defect(Enum):
    MISSING = "it is not in the root file system"
    NOT_EXECUTABLE = "its mode lets nobody execute it"
    PLAIN = "its mode in the repository lets nobody execute it, and nothing changes it"
    WRITTEN = "what writes it gives it no execute permission"


class Unstartable(NamedTuple):
    defect: Defect
    source: Source | None
    """The file; None when it is missing."""


def is_own_program(process: Process) -> bool:
    """Whether a command line must start a program of one's own, by a path that is known."""
    program, unit = process.program, process.unit
    if "-" in process.prefixes or not OF_NO_PACKAGE.match(program) or "$" in program or "%" in program:
        return False
    return not unit.is_opaque(process.line) and not unit.get("RootDirectory") and not unit.get("RootImage")


def unstartable(process: Process, filesystem: Filesystem) -> Iterator[Unstartable]:
    """What keeps systemd from starting the program of a command line."""
    program, tree = str(process.program), filesystem.files.tree
    source = tree.find(program)
    if source is None:
        if tree.complete and filesystem.exists(program) is False:
            yield Unstartable(Defect.MISSING, None)
        return
    if source.mode is not None and not source.mode & 0o111:
        yield Unstartable(Defect.NOT_EXECUTABLE, source)
    if (
        tree.root is None
        and source.origin is None
        and not _is_named_template(source)
        and _lacks_mode(filesystem.files, source)
    ):
        yield Unstartable(Defect.PLAIN, source)
    if source.origin is not None and source.origin.certain and not _is_made_executable(filesystem.files, source):
        yield Unstartable(Defect.WRITTEN, source)


def _is_named_template(source: Source) -> bool:
    """Whether another file is made of it, which gets its own mode."""
    return final_name(source.name) != source.name


def _lacks_mode(files: Files, source: Source) -> bool:
    """Whether a script of the repository is not executable in the checkout, and nothing says that it becomes so."""
    tree = files.tree
    if not source.text.startswith("#!") or not tree.keeps_modes or tree.is_executable(source.name):
        return False
    guides = filter(None, map(tree.read, tree.named("README.md")))
    texts = (*(each.text for each in (*files.sources, *guides)), *scripts_of(tree))
    return not any(_may_execute(source, text) for text in texts)


def _may_execute(source: Source, text: str) -> bool:
    """Whether a text gives a file the mode of a program, or perhaps does."""
    if _MODE.search(text) and (source.basename in text or _ITEMS.search(text)):
        return True
    if "PROGRAMS" in text and source.basename in text:
        return True
    lines = _GIVES_MODE.findall(text)
    return any(source.basename in line or _SEVERAL.search(line) for line in lines)


def _is_made_executable(files: Files, source: Source) -> bool:
    """Whether what writes a file, or another file that names it, may make it executable: a script with ``chmod`` or
    ``install``, user data and plays with a mode."""
    assert source.origin is not None
    writer = source.origin.whole.source
    if writer.kind != "shell-script" and _MODE.search(writer.text):
        return True
    changes = _CHANGES.findall(writer.text)
    if any(source.basename in line or (line.startswith("chmod") and _SEVERAL.search(line)) for line in changes):
        return True
    others = (each.text for each in files.sources if each is not writer)
    return any(source.basename in text and _CHANGES.search(text) for text in others)
