"""Programs that drive motors over pins or a bus, and end without stopping them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.commands.repeating import bus_in_cpp
from bringup_lint.graph.nodes.questions.commands.repeating import driven_bus
from bringup_lint.graph.nodes.questions.commands.repeating import is_held
from bringup_lint.graph.nodes.questions.ending.safe_state import has_safe_state
from bringup_lint.graph.nodes.sources.age import COMMENTS
from bringup_lint.graph.nodes.sources.ending import Spin
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_source import CppNode
from bringup_lint.model.node_source import Endpoint
from bringup_lint.model.node_source import NodeSource
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.source import Source

_RELEASED = ("gpiozero",)
"""Libraries that release their pins when the process exits."""
_MAY_STOP = regex(
    r"~\w+\s{0,4}\(|on_shutdown|pre_shutdown|\bsignal\s{0,4}\(|sigaction|atexit|SignalHandlerOptions|on_deactivate|signal_set"
)
"""What of a C++ program may run when it ends."""
_SPIN = regex(r"\brclcpp::spin\s{0,4}\([^;]{1,200}\)\s{0,4};")
_CALL = regex(r"(?<![\w:])(?!rclcpp::shutdown\b)[A-Za-z_][\w:]{0,60}\s{0,4}\(")


class UnsafeHardware(NamedTuple):
    file: NodeSource
    spin: Spin
    bus: str
    command: Endpoint
    """The subscription whose last message stays in force."""


def unsafe_hardware(nodes: Nodes) -> Iterator[UnsafeHardware]:
    for file in nodes.robot_sources:
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


class UnsafeCpp(NamedTuple):
    source: Source
    spin: Span
    bus: str
    command: Endpoint


def unsafe_in_cpp(nodes: Nodes) -> Iterator[UnsafeCpp]:
    """The same for C++ files with a ``main`` that only spins the node."""
    for node in nodes.cpp:
        command = next((each for each in node.endpoints if is_held(each)), None)
        spin = only_spin(nodes, node) if command is not None else None
        bus = bus_in_cpp(with_header(nodes, node.source)) if spin is not None else None
        if command is not None and bus is not None and spin is not None:
            yield UnsafeCpp(node.source, spin, bus, command)


def only_spin(nodes: Nodes, node: CppNode) -> Span | None:
    """The last spin of a file, where nothing comes after it, and nothing of the file may run when the program ends."""
    spins = list(_SPIN.finditer(node.source.text))
    if not spins or _CALL.search(node.source.text, spins[-1].end()):
        return None
    if _MAY_STOP.search(COMMENTS.sub("", with_header(nodes, node.source))):
        return None
    return Span(node.source, spins[-1].start(), spins[-1].end())
