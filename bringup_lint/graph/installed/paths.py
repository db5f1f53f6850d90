"""Paths that scripts name: on the robot, and in the tree."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from fnmatch import fnmatchcase

from bringup_lint.discover.tree import Tree
from bringup_lint.discover.tree import display_name
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_TOPS = r"(?:etc|usr|lib|opt|var|boot|home|root|run|srv)"
_MOUNTED = regex(rf"(?:\{{\{{ \w+ \}}\}}|/mnt|/target|/rootfs|\.?\.?/?[\w.-]*root(?:fs)?)(?P<path>/{_TOPS}/.*)", re.S)
_ROLE = regex(r"(?:.*/)?roles/[^/]+/")
_PLACEHOLDER = regex(r"\{\{ [^{}]* \}\}")
_HOME = regex(r"(?:~|\{\{ HOME \}\})(?=/)")
_FOLDER_NAMES = frozenset({"system", "user", "bin", "sbin", "netplan", "systemd", "default", "share", "lib"})


def robot_path(path: str) -> str | None:
    """The path on the robot; without the folder that an image is built in. None for one that is not known."""
    path = _HOME.sub("/home/user", path)
    if mounted := _MOUNTED.fullmatch(path):
        path = mounted["path"]
    if not path.startswith("/") or _PLACEHOLDER.search(posixpath.basename(path)):
        return None
    return posixpath.normpath(path)


def destination(path: str, name: str, *, several: bool) -> str | None:
    """Where cp and its like put a file of this name."""
    whole = robot_path(path)
    if whole is None:
        return None
    base = posixpath.basename(whole)
    extension = posixpath.splitext(name)[1]
    folder = several or path.endswith("/") or base.endswith(".d") or base in _FOLDER_NAMES
    if not folder and extension and not posixpath.splitext(base)[1]:
        folder = True
    return f"{whole}/{name}" if folder else whole


def in_tree(tree: Tree, path: str, script: Source) -> Iterator[str]:
    """The files of the tree that a word of a script means; nothing when that is not clear."""
    tail = _PLACEHOLDER.split(path)[-1].lstrip("/") if _PLACEHOLDER.search(path) else path
    tail = re.sub(r"^(?:\.{1,2}/)+", "", tail)
    if not tail or tail.startswith(("/", "~")) or tail.endswith("/"):
        return
    known = _matching(tree, tail)
    beside = [each for each in known if posixpath.dirname(display_name(each)) == _folder(script, tail)]
    if "*" in tail:
        folders = {posixpath.dirname(each) for each in known}
        yield from known if len(folders) == 1 else beside
    elif len(known) == 1:
        yield known[0]
    elif len(beside) == 1:
        yield beside[0]
    elif len(own := [each for each in known if role_of(script.name) == role_of(display_name(each)) != ""]) == 1:
        yield own[0]


def role_of(path: str) -> str:
    """The folder of the Ansible role that a file belongs to; empty when it belongs to none."""
    match = _ROLE.match(path)
    return match[0] if match else ""


def _matching(tree: Tree, tail: str) -> list[str]:
    if "*" not in tail:
        return [each for each in tree.named(posixpath.basename(tail)) if each.endswith(f"/{tail}")]
    return [each for each in tree.paths if fnmatchcase(each, f"*/{tail}")]


def _folder(script: Source, tail: str) -> str:
    return posixpath.normpath(posixpath.join(posixpath.dirname(script.name), posixpath.dirname(tail)))
