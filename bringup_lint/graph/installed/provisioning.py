"""What Ansible and cloud-init put on the robot, in the shape in which scripts do it."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from bringup_lint.discover.tree import Tree
from bringup_lint.graph.installed.paths import destination
from bringup_lint.graph.installed.paths import in_tree
from bringup_lint.graph.installed.script import Written
from bringup_lint.graph.installed.text import as_it_is
from bringup_lint.parsers.ansible import Put
from bringup_lint.source import Source
from bringup_lint.templates import final_name

KINDS = ("ansible", "cloud-init")


def written(put: Put) -> Written | None:
    """What a task writes itself; None for a copy of a file."""
    if put.text is None:
        return None
    text = as_it_is(put.text)
    if put.appends and not str(text).endswith("\n"):
        end = put.text.span.end
        text.add("\n", end, end)
    return Written(str(put.path), text, put.appends, put.path, put.certain)


def copies(put: Put, tree: Tree, source: Source) -> Iterator[tuple[str, str]]:
    """The files of the tree that a task copies, with their paths on the robot."""
    if put.copied is None or "{{" in posixpath.basename(put.copied):
        return
    for path in in_tree(tree, str(put.copied), source):
        target = destination(str(put.path), final_name(posixpath.basename(path)), several=False)
        if target is not None:
            yield path, target
