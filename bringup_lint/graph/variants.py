"""Whether two files belong to one robot. A repository holds variants, examples and several robots.

Files of one root file system or overlay belong together, those of two do not. Elsewhere two files are kept apart when
the folders below their common one are alike: when both hold units, launch files, environments or the like.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from collections.abc import Set as AbstractSet
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.starters import STARTERS
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree

TELLING = frozenset(
    {
        "cyclonedds",
        "env-file",
        "fastdds",
        "fstab",
        "launch-python",
        "launch-xml",
        "launch-yaml",
        "netplan",
        "nftables",
        "params",
        "sros2-governance",
        "sros2-permissions",
        "sysctl",
        "udev-rules",
        *(kind for starter in STARTERS.values() if starter.own for kind in starter.kinds),
    }
)
"""Kinds of which each robot has its own."""
_NONE: frozenset[str] = frozenset()
"""The kinds below a file, which is not a folder: it is for whatever the folders beside it are for."""


def overlay_of(source: Source) -> str | None:
    """The folder that stands for the root of a robot, as it is written; None outside of any."""
    path = source.robot_path
    if path is None or not source.name.endswith(path.lstrip("/")):
        return None
    return source.name[: -len(path.lstrip("/"))]


@dataclass(eq=False)
class Variants:
    """The robots and variants of one tree."""

    tree: Tree

    def same_robot(self, one: Source, other: Source) -> bool:
        """Whether two files are for the same robot, as far as their places tell."""
        if one is other or self.tree.complete:
            return True
        roots = overlay_of(one), overlay_of(other)
        if None not in roots:
            return roots[0] == roots[1]
        ours, theirs = (source.absolute.split("/") for source in (one, other))
        depth = next((at for at, (our, their) in enumerate(zip(ours, theirs)) if our != their), 0)
        one_side, other_side = (self._kinds_below.get("/".join(path[: depth + 1]), _NONE) for path in (ours, theirs))
        return not (one_side & other_side)

    def names(self, robot_path: str, asked_by: Source, found: Source) -> bool:
        """Whether a path on the robot that a file names is this file: not one of another overlay, and not just one of
        the same name in another variant."""
        roots = overlay_of(asked_by), overlay_of(found)
        if None not in roots:
            return roots[0] == roots[1]
        tail = robot_path.strip("/").split("/")[-2:]
        return found.name.split("/")[-2:] == tail or self.same_robot(asked_by, found)

    @cached_property
    def _kinds_below(self) -> Mapping[str, AbstractSet[str]]:
        """The telling kinds of the files below every folder."""
        found: dict[str, set[str]] = {}
        for source in self.tree.sources:
            if source.kind in TELLING:
                folder = source.absolute
                while len(folder) > 1:
                    folder = os.path.dirname(folder)
                    kinds = found.setdefault(folder, set())
                    if source.kind in kinds:
                        break
                    kinds.add(source.kind)
        return found
