"""Components that end the process which they are loaded into, with the launch files that load them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import literal_text
from bringup_lint.model.cpp_source import ComponentEnd
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


class EndedContainer(NamedTuple):
    ends: list[ComponentEnd]
    """Those of one component, in the order of the text."""
    loaded: Span | None
    """Where a launch file loads the component into a container; None for what no file registers, or loads."""


def ended_containers(nodes: Nodes) -> Iterator[EndedContainer]:
    """One for each component."""
    loaded = {str(text): each.span for each in nodes.launch.nodes if (text := literal_text(each.plugin)) is not None}
    for source in nodes.cpp:
        by_component: dict[str, list[ComponentEnd]] = {}
        for each in source.component_ends:
            by_component.setdefault(each.component, []).append(each)
        yield from (EndedContainer(ends, loaded.get(name)) for name, ends in by_component.items())
