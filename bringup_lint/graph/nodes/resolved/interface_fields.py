"""The fields of messages: those of the workspace's own packages, and of the common ones."""

from __future__ import annotations

import os
from collections.abc import Iterator
from collections.abc import Mapping
from functools import cache
from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.graph.interface_files import interface_files
from bringup_lint.graph.memo import memo
from bringup_lint.parsers.interface import Fields
from bringup_lint.parsers.interface import fixed_arrays
from bringup_lint.parsers.interface import parse

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.workspace import Workspace

_PARTS = {
    "msg": ("",),
    "srv": ("_Request", "_Response"),
    "action": ("_Goal", "_Result", "_Feedback"),
}


_FEEDBACK_MESSAGE = "_FeedbackMessage"


class InterfaceFields:
    """Types are named as ``geometry_msgs/msg/Twist`` and ``std_srvs/srv/SetBool_Request``."""

    def __init__(self, tree: Tree, workspace: Workspace) -> None:
        self._tree = tree
        self._workspace = workspace
        self._read: dict[str, Fields | None] = {}

    def fields(self, type_: str) -> Mapping[str, str] | None:
        """The fields and constants of a type; None when they are not known."""
        if type_ not in self._read:
            is_sent = type_.endswith(_FEEDBACK_MESSAGE)
            self._read[type_] = self._feedback(type_) if is_sent else self._find(type_)
        return self._read[type_]

    def is_fixed(self, type_: str, field: str) -> bool:
        """Whether a field of a message of the workspace is an array that always has the same number of elements."""
        package, kind, name = (*type_.split("/"), "", "")[:3]
        text = self._text(package, kind, name) if package in self._workspace.packages else None
        return text is not None and field in fixed_arrays(text)

    def _feedback(self, type_: str) -> Fields | None:
        """What the callback for the feedback of an action gets."""
        feedback = type_.removesuffix("Message")
        if self.fields(feedback) is None:
            return None
        return {"goal_id": "unique_identifier_msgs/UUID", "feedback": feedback}

    def _find(self, type_: str) -> Fields | None:
        package, kind, name = (*type_.split("/"), "", "")[:3]
        if package in self._workspace.ambiguous:
            return None
        if package not in self._workspace.packages:
            return _common().get(type_)
        name, _, part = name.partition("_")
        text = self._text(package, kind, name)
        if text is None:
            return None
        parts = parse(text, package)
        names = _PARTS[kind]
        wanted = f"_{part}" if part else ""
        if wanted not in names or len(parts) != len(names):
            return None
        return parts[names.index(wanted)]

    def _text(self, package: str, kind: str, name: str) -> str | None:
        path = self._files_of(package).get((kind, name))
        if path is None or os.path.basename(os.path.dirname(path)) != kind or not path.endswith(f".{kind}"):
            return None
        source = self._tree.read(path, "interface", judged=False)
        return source.text if source is not None and not source.template else None

    @memo
    def _files_of(self, package: str) -> dict[tuple[str, str], str]:
        return interface_files(self._tree, self._workspace.packages[package].folder)


@cache
def _common() -> dict[str, Fields]:
    """The types of the table."""
    return {row["type"]: dict(_pairs(row["fields"])) for row in table("ros/message_fields")}


def _pairs(text: str) -> Iterator[tuple[str, str]]:
    for each in text.split():
        name, _, kind = each.partition(":")
        yield name, kind
