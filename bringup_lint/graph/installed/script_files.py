"""The files of a repository that its scripts copy, source and run, and the folders in which they look for them."""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.folders import above
from bringup_lint.graph.installed.script import Run
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.installed.scripts import Scripts

_COPIES = ("cp", "install", "ln")
_READS = ("source", ".", "bash", "sh", "python3", "python")
_TAKES = {"pip": ("-r", "--requirement"), "pip3": ("-r", "--requirement"), "docker": ("-f", "--file")}
_TAKES["docker-compose"] = _TAKES["docker"]
"""Options with a file that the command reads."""
_VALUED = ("-o", "-g", "-m", "-S", "-t")
GENERATED = regex(
    r"(?:^|/)(?:install|devel|build|log|\.?v?env|node_modules|target|dist|out|output|tmp|certs?|keys?|keystore)/"
    r"|\.(?:hex|bin|elf|uf2|so|o|a|ko|dtbo?|deb|whl|jar|img|zip|tgz|onnx|engine|tflite|pth?|weights|bag|db3|mcap)$"
    r"|\.tar(?:\.\w+)?$"
)
"""Folders and files that a build makes, or that a repository does not hold."""
_SETTINGS = regex(r"\.env$")
_ASSIGNED = regex(
    r"^[ \t]*(?:readonly[ \t]+|export[ \t]+|local[ \t]+|declare[ \t]+-\w+[ \t]+)?(?P<name>\w+)="
    r"(?P<value>[\"']?\$[({\w][^\n]{0,200})$",
    re.M,
)
_SELF = regex(r"\$\([^\n]{0,60}?dirname[^\n]{0,40}(?:\$0|BASH_SOURCE|\$\{0\})")
_OTHER = regex(r"[\"']?(?:\$\((?:cd|dirname|realpath|readlink -f)[ \t]+(?:-\S+[ \t]+)*)?[\"']?\$\{?(?P<name>\w+)\}?")
_QUIET = regex(r"[12&]?>[ \t]*/dev/null|2>&1|&&.*$")
_MOVES = regex(r"^[ \t]*(?:cd|pushd)[ \t]+(?P<to>[^\n;&|]+)", re.M)
_PLAIN = regex(r"(?:\./)?[A-Za-z0-9_.+-]+(?:/[A-Za-z0-9_.+-]+)*(?:\.[A-Za-z0-9]+|/[\w.-]*\*\.[a-z]+)")
_BELOW = regex(r"\{\{ (\w+) \}\}/(.+)")
_LEAST = 2
"""Other files of the same folder that show that relative paths start there."""


class NamedFile(NamedTuple):
    word: Located
    path: str
    """Relative to the folder."""
    folder: str | None
    """The folder that the script says, relative to its own; None: it is not said."""


class _Base(NamedTuple):
    folder: str | None = None
    """The folder in which relative paths start; None when that is not clear."""
    shown: int = 0
    """How many files show it."""


def missing_files(scripts: Scripts, source: Source) -> Iterator[NamedFile]:
    """The files that a script needs and that its repository certainly lacks."""
    tree = scripts.files.tree
    folders = _own_folders(source.text)
    runs = [did for did in scripts.done(source) if isinstance(did, Run)]
    needed = (run for at, run in enumerate(runs) if _is_needed(runs[at:]))
    named = list(dict.fromkeys(each for run in needed for each in _named(run, folders)))
    base = _base(tree, source, [each for each in named if each.folder is None])
    there = _found(tree, source, named)
    for each in named:
        folder = _start(each, base) if each.folder is None else _below(source, each.folder)
        if each.folder is not None and not any(path.startswith(str(folder).lstrip(".")) for path in there):
            continue
        is_sure = each.folder is not None or base.shown > _LEAST
        if folder is None or not _is_missing(scripts, source, folder, each, is_sure):
            continue
        if not _is_made(scripts, source, each):
            yield each


def _is_made(scripts: Scripts, source: Source, named: NamedFile) -> bool:
    """Whether another script writes a file of this name."""
    name = posixpath.basename(named.path)
    written = re.compile(rf"(?:>|\btouch\b|\btee\b|-o\b|--output\b)[^\n;&|>]{{0,200}}{re.escape(name)}")
    others = (other.text for other in scripts.files.of_kind("shell-script") if other is not source)
    return any(name in text and written.search(text) for text in others)


def _start(named: NamedFile, base: _Base) -> str | None:
    """The folder in which a relative path starts; None when too little shows it."""
    return base.folder if base.shown >= _LEAST or "/" in named.path else None


def _below(source: Source, *parts: str) -> str:
    """A path from the folder of a script on."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(source.name), *parts))


def _found(tree: Tree, source: Source, named: list[NamedFile]) -> list[str]:
    """The files of which the script says the folder, and that are there."""
    paths = (_below(source, each.folder, each.path) for each in named if each.folder is not None)
    return [path for path in paths if tree.exists(path)]


def _own_folders(text: str) -> dict[str, str]:
    """Variables that hold the folder of the script or one near it -> the path from there. Not those that a second
    line changes."""
    found: dict[str, str] = {}
    for match in _ASSIGNED.finditer(text):
        name, value = match["name"], _QUIET.sub("", match["value"])
        other = _OTHER.match(value)
        if _SELF.search(value):
            path = _steps(value, value.count("dirname") - 1)
        elif other is not None and other["name"] in found:
            path = _steps(value[other.end() :], value[: other.end()].count("dirname"))
            path = None if path is None else posixpath.normpath(posixpath.join(found[other["name"]], path))
        else:
            path = None
        if path is None or found.get(name, path) != path:
            found.pop(name, None)
        else:
            found[name] = path
    return found


def _steps(value: str, up: int) -> str | None:
    """The path that the rest of a value adds to a folder; None where it is not clear."""
    rest = re.sub(r"\$\{BASH_SOURCE[^}]*\}|\$\{?0\}?|\$BASH_SOURCE", "", value)
    if re.search(r"[|;*]|\$\{?\w|basename", rest.replace("$(", "(")):
        return None
    parts = re.findall(r"/([\w.-]+)", rest)
    return posixpath.normpath(posixpath.join(*[".."] * up, *parts, "."))


def _named(run: Run, folders: dict[str, str]) -> Iterator[NamedFile]:
    """The files that a command reads."""
    for word in read_words(run):
        text = run.text(word)
        below = _BELOW.fullmatch(text)
        if below and below[1] in folders and _PLAIN.fullmatch(below[2]):
            yield NamedFile(word, posixpath.normpath(below[2]), folders[below[1]])
        elif _PLAIN.fullmatch(text) and str(word) == text:
            yield NamedFile(word, posixpath.normpath(text), None)


def _is_needed(runs: list[Run]) -> bool:
    """Whether nothing shows that the first command may fail."""
    if runs[0].command.hides_errors:
        return False
    ends = next((run.command.ends for run in runs if run.command.ends != "&&"), "")
    return ends != "||"


def read_words(run: Run) -> Iterator[Located]:
    """The words of a command that name files which it reads."""
    words = run.words
    if run.name in _COPIES:
        given = [
            word for at, word in enumerate(words) if at and not word.startswith("-") and words[at - 1] not in _VALUED
        ]
        if run.name != "ln" and any(re.fullmatch(r"-[a-zA-Z]*[dt][a-zA-Z]*|--directory", word) for word in words[1:]):
            return
        yield from (word for word in given[:-1] if run.name != "ln" or word.startswith("$"))
    elif run.name in _READS and len(words) > 1 and not words[1].startswith("-"):
        yield words[1]
    elif words and words[0].startswith(("./", "$")) and "/" in words[0]:
        yield words[0]
    else:
        options = _TAKES.get(run.name, ())
        yield from (word for at, word in enumerate(words) if at and words[at - 1] in options)


def _base(tree: Tree, source: Source, named: list[NamedFile]) -> _Base:
    moves = [match["to"] for match in _MOVES.finditer(source.text)]
    folders = _moved(source, moves) if moves else _above(posixpath.dirname(source.name))
    counts = {each: sum(tree.is_file(posixpath.join(each, one.path)) for one in named) for each in folders}
    best = max(folders, key=lambda each: counts[each], default="")
    certain = counts.get(best) and list(counts.values()).count(counts[best]) == 1
    return _Base(best, max(counts[best], _LEAST if moves else 0)) if certain else _Base()


def _moved(source: Source, moves: list[str]) -> list[str]:
    """The folder into which a script goes first, when it is said from its own one and the script stays there."""
    first = moves[0]
    if len(moves) > 1 or not _SELF.search(first):
        return []
    path = _steps(first, first.count("dirname") - 1)
    return [] if path is None else [_below(source, path)]


def _above(folder: str) -> list[str]:
    """A folder, and all above it up to the first."""
    return [folder, *above(folder), *(["/" if folder.startswith("/") else ""] if folder.strip("/") else [])]


def _is_missing(scripts: Scripts, source: Source, base: str, named: NamedFile, is_sure: bool) -> bool:
    """Whether the tree lacks a file, and nothing may make it; where the folder is sure, also one without its folder."""
    tree = scripts.files.tree
    path = posixpath.normpath(posixpath.join(base, named.path))
    folder, _, name = path.rpartition("/")
    is_made = GENERATED.search(path) is not None or _SETTINGS.search(path) is not None
    if is_made or tree.exists(path) or tree.is_ignored(path.replace("*", "any")):
        return False
    if any(os.path.abspath(path).startswith(each) for each in tree.submodules):
        return False
    if tree.matches(f"{path}.*") and not _is_only_template(scripts, path):
        return False
    if "*" in name:
        return not tree.matches(path) and (tree.exists(folder or ".") or _is_missing_folder(tree, source, folder))
    inner = "/".join(named.path.split("/")[-2:]) if is_sure and named.folder is None else name
    if len(re.findall(rf"(?<![\w.-]){re.escape(inner)}(?![\w-])", source.uncommented)) > 1:
        return False
    return tree.exists(folder or ".") or (is_sure and _is_missing_folder(tree, source, folder))


def _is_only_template(scripts: Scripts, path: str) -> bool:
    """Whether a template is all that is there, and no file of the tree says that it is filled in."""
    name = posixpath.basename(path)
    if not scripts.files.tree.is_file(f"{path}.in"):
        return False
    return not scripts.files.mentions(re.compile(rf"{re.escape(name)}\.in\b|\*\.in\b|configure_file"))


def _is_missing_folder(tree: Tree, source: Source, folder: str) -> bool:
    """Whether the folder above is there, and nothing in the script makes this one."""
    outer, _, name = folder.rpartition("/")
    made = re.search(
        rf"\b(?:mkdir|clone|unzip|tar|rsync|scp|wget|curl|colcon)\b[^\n]*(?<![\w.-]){re.escape(name)}\b", source.text
    )
    return tree.exists(outer or ".") and made is None
