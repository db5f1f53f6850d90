"""Files that RewrittenYaml shall give to parameters which the parameter file does not have."""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.launch_values import DerivedFile
from bringup_lint.model.launch_values import DictValue
from bringup_lint.model.launch_values import ParameterFile as LaunchedFile
from bringup_lint.model.launch_values import Value
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import ParameterFile


_NAME = regex(r"\w+")
_KEY = regex(r"(?<![\w.])(\w+)['\"]?[ \t]*:")
_GOALS = {
    "default_nav_through_poses_bt_xml": ("{goals}", "{goal}"),
    "default_nav_to_pose_bt_xml": ("{goal}", "{goals}"),
}
"""What the navigator sets for the trees of an action, and for those of the other one (navigate_through_poses.cpp,
navigate_to_pose.cpp)."""


class Unmatched(NamedTuple):
    key: Located
    file: ParameterFile
    """The one that has no such key."""
    given: str
    """The name of the file that the parameter does not get."""


def unmatched_rewrites(params: Params, launch: Launch) -> Iterator[Unmatched]:
    """Rewrites of single names: those of a whole path with ``ros__parameters`` are added from Jazzy on."""
    found: dict[tuple[str, int], Unmatched] = {}
    for expansion in launch.entries:
        for node in expansion.nodes:
            for source in node.parameters:
                for each in _of(params, launch, source):
                    found.setdefault((each.key.span.source.name, each.key.span.start), each)
    yield from found.values()


def _of(params: Params, launch: Launch, source: Value) -> Iterator[Unmatched]:
    derived = source.file if isinstance(source, LaunchedFile) else source
    if not isinstance(derived, DerivedFile) or not isinstance(derived.rewrites, DictValue):
        return
    base = launch.find(derived.base) if derived.helper == "RewrittenYaml" else None
    file = params.at_path(base.file) if base is not None and base.file is not None else None
    if file is None:
        return
    for key, value in derived.rewrites.items:
        name, given = literal_text(key), launch.find(value)
        if name is None or "." in name or given is None or given.file is None or not name.span.source.judged:
            continue
        if not _has(file, name) and not _is_of_other_action(params, name, given.file):
            yield Unmatched(name, file, os.path.basename(given.file))


def _is_of_other_action(params: Params, name: str, path: str) -> bool:
    """Whether a tree reads only what the navigator sets for the other action: it would fail, and that of Nav2 does
    not."""
    own, other = _GOALS.get(name, ("", ""))
    tree = params.files.tree.at(path) if own else None
    return tree is not None and own not in tree.text and other in tree.text


def _has(file: ParameterFile, name: str) -> bool:
    """Whether a file may have a key; of a name with other signs that is not known."""
    return not _NAME.fullmatch(name) or name in file.source.once(_KEY, partial(_keys, file.source))


def _keys(source: Source) -> set[str]:
    return {key for line in source.text.splitlines() for key in _KEY.findall(line.partition("#")[0])}
