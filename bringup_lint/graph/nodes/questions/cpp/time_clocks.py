"""C++ callbacks that subtract times of different clocks."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.model.cpp_source import CppNode
from bringup_lint.model.cpp_source import TimeMember
from bringup_lint.model.cpp_source import TimeUse
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


class ClockMix(NamedTuple):
    use: TimeUse
    member: TimeMember


def clock_mixes(nodes: Nodes) -> Iterator[list[ClockMix]]:
    """Those of one source together. The class is in the same file, or in one file of the same package."""
    for source in nodes.cpp:
        found = [ClockMix(use, member) for use in source.time_uses if (member := _member(nodes, source, use))]
        if found:
            yield found


def _member(nodes: Nodes, source: CppNode, use: TimeUse) -> TimeMember | None:
    own = [each for each in source.time_members if _is_of(each, use)]
    if own:
        return own[0] if len(own) == 1 else None
    word = re.compile(rf"\b{re.escape(use.name)}\b")
    package = nodes.launch.workspace.owner(source.source)
    near = [
        each
        for each in nodes.cpp
        if each is not source
        and use.owner in each.source.text
        and word.search(each.source.text)
        and nodes.launch.workspace.owner(each.source) is package
    ]
    if len(near) != 1 or len(word.findall(near[0].source.text)) != 1:
        return None
    found = [each for each in near[0].time_members if _is_of(each, use)]
    return found[0] if len(found) == 1 else None


def _is_of(member: TimeMember, use: TimeUse) -> bool:
    return (str(member.name), member.owner) == (use.name, use.owner)
