"""Elements that C++ callbacks take unseen from arrays whose size messages choose."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.short_arrays import COMMON
from bringup_lint.facts.ros.short_arrays import EMPTY
from bringup_lint.facts.ros.short_arrays import JOYSTICK

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.cpp_source import CppNode
    from bringup_lint.model.cpp_source import UncheckedElements


def unchecked_elements(nodes: Nodes) -> Iterator[tuple[CppNode, UncheckedElements]]:
    """Left out are arrays of a fixed size, and fields of messages that are not known."""
    for source in nodes.cpp:
        for found in source.unchecked_elements:
            if all(_is_short(nodes, found.type, each.field) for each in found.told):
                yield source, found


def _is_short(nodes: Nodes, type_name: str, field: str) -> bool:
    if field in (COMMON if type_name == JOYSTICK else EMPTY.get(type_name, ())):
        return True
    known = nodes.interfaces.fields(type_name) or {}
    return known.get(field, "").endswith("[]") and not nodes.interfaces.is_fixed(type_name, field)
