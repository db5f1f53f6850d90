"""Programs that drive motors over pins or a bus, and end without stopping them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.repeating import driven_bus
from bringup_lint.graph.nodes.questions.repeating import is_held
from bringup_lint.graph.nodes.questions.safe_state import has_safe_state
from bringup_lint.graph.nodes.sources.ending import Spin
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_RELEASED = ("gpiozero",)
"""Libraries that release their pins when the process exits."""


class UnsafeHardware(NamedTuple):
    file: NodeSource
    spin: Spin
    bus: str
    command: Endpoint
    """The subscription whose last message stays in force."""


def unsafe_hardware(nodes: Nodes) -> Iterator[UnsafeHardware]:
    for file in nodes.programs:
        ending = nodes.ending(file)
        if not ending.spins or ending.signals is None:
            continue
        made = nodes.made(file)
        for node in made:
            bus = driven_bus(nodes, nodes.file_of(node))
            command = next((each for each in node.all_endpoints if is_held(each)), None)
            if command is None or bus is None or bus in _RELEASED:
                continue
            if not has_safe_state(ending, made):
                yield UnsafeHardware(file, ending.spins[0], bus, command)
            break
