"""The folders below a home that containers of the tree have, whatever the machine: mounts, WORKDIR, COPY."""

from __future__ import annotations

import re
from collections.abc import Iterable

from bringup_lint.graph.files import Files
from bringup_lint.pattern import regex
from bringup_lint.source import Source

CONTAINER_KINDS = ("dockerfile", "compose", "shell-script", "devcontainer")
"""Kinds of file that say what a container holds."""
_HOME = r"(?P<path>/(?:home/[\w.-]+|root)(?:/[\w./-]*)?)"
_HOMES = ("/home/", "/root")
"""One of them is in every such path, which is found out much sooner."""
_FOLDER = regex(r"/(?:home/[\w.-]+|root)/[\w-][\w.-]*")
_FILLS = regex(r"\b(?:mkdir|cp|clone|rsync|scp|install|mv|ln|unzip|tar|COPY|ADD|WORKDIR)\b")
_MAKE = regex(r"(?:^|/)(?:(?:GNUm|[mM])akefile|\.?[jJ]ustfile|[^/]*\.mk)$")
_SIZE = 200_000
"""How much is read of one."""
_FORMS = (
    regex(rf"(?:^|[ \t])(?:-v|--volume)[ =]?[\"']?[^\s:]+:{_HOME}", re.M),
    regex(rf"\b(?:target|dst|destination|workspaceFolder)[\"']?[=:][ \t]*[\"']?{_HOME}"),
    regex(rf"^[ \t]*-[ \t]+[\"']?[^\s:\"']+:{_HOME}", re.M),
    regex(rf"(?:^[ \t]*WORKDIR[ \t]+|\bworking_dir:[ \t]*|(?<![\w-])(?:--workdir|-w)[ =])[\"']?{_HOME}", re.M),
    regex(rf"^[ \t]*(?:COPY|ADD)[ \t][^\n]*[ \t]{_HOME}[ \t]*$", re.M),
)


def container_folders(sources: Iterable[Source]) -> frozenset[str]:
    """The folders that are the target of a mount or a copy, or a working directory, of a container."""
    texts = (source.text for source in sources if any(home in source.text for home in _HOMES))
    found = (match for text in texts for form in _FORMS for match in form.finditer(text))
    return frozenset(match["path"].rstrip("/") for match in found)


def is_in_container(path: str, folders: Iterable[str]) -> bool:
    """Whether a path is in one of the folders."""
    return any(path == folder or path.startswith(f"{folder}/") for folder in folders)


def deploying(files: Files) -> list[str]:
    """The texts of scripts, Dockerfiles and Makefiles, which put things where the robot has them."""
    scripts = [source.text for source in files.of_kind("shell-script", "dockerfile") if source.judged]
    return [*scripts, *files.tree.pages(_MAKE, _SIZE)]


def is_deployed_to(path: str, texts: Iterable[str]) -> bool:
    """Whether a text of these puts something into the folder of a home in which a path is, as on the robot."""
    match = _FOLDER.match(path)
    if match is None:
        return False
    near = (text for text in texts if match[0] in text)
    lines = (line.partition(match[0]) for text in near for line in text.splitlines() if match[0] in line)
    return any(_FILLS.search(before) and not after[:1].isalnum() for before, _, after in lines)
