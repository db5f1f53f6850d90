"""Devices as nodes: who opens them, and the udev rules that make their names."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.edges.launch import ros_node
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node
from bringup_lint.graph.graph import Origin
from bringup_lint.graph.host.device_uses import device_path
from bringup_lint.graph.udev.rule import Link
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.host.device_uses import DeviceUse
    from bringup_lint.graph.host.devices import Devices
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.places import Places
    from bringup_lint.graph.udev.udev import Udev

OPENERS = ("unit", "user-unit", "compose-service", "ros-node", "process", "script")
NO_HARDWARE = frozenset(
    {
        "console",
        "fd",
        "full",
        "kmsg",
        "log",
        "null",
        "ptmx",
        "random",
        "stderr",
        "stdin",
        "stdout",
        "tty",
        "urandom",
        "zero",
    }
)
"""What the kernel and systemd always have below /dev."""
_HOW = {
    "literal": "path",
    "host": "devices:",
    "script": "path in a script",
    "default": "default value",
    "argument": "default value",
}


def device_edges(devices: Devices, params: Callable[[], Params], places: Places) -> Iterator[Edge]:
    """``opens`` from processes, ``names`` from files whose reader is not known, ``stands-for`` from device units."""
    for use in devices.uses:
        if use.certainty == "unit" or str(use.path).removeprefix("/dev/") in NO_HARDWARE:
            continue
        device = Node("device", str(use.path))
        for holder in places.of(use.path.span):
            if holder.kind == "parameter-file":
                yield from _of_parameters(use, holder, device, params())
            else:
                kind = "opens" if holder.kind in OPENERS else "names"
                yield Edge(kind, holder, device, use.path.span, _HOW[use.certainty])


def _of_parameters(use: DeviceUse, holder: Node, device: Node, params: Params) -> Iterator[Edge]:
    yield Edge("names", holder, device, use.path.span, "parameter")
    for file in params.judged:
        if file.source is use.path.span.source:
            parameter = next((each for each in file.parameters if each.span.holds(use.path.span)), None)
            if parameter is None:
                continue
            for load in params.effective(file, parameter):
                yield Edge("opens", ros_node(load.node), device, use.path.span, str(parameter.name))


def device_units(nodes: Iterable[Node]) -> Iterator[Edge]:
    """``stands-for``, from the device units that units name to the devices."""
    for node in nodes:
        path = device_path(node.name) if node.kind == "unit" else None
        if path is not None:
            yield Edge("stands-for", node, Node("device", path), None, "a device unit", origin=Origin.IMPLICIT)


def rule_edges(udev: Udev, nodes: Iterable[Node]) -> Iterator[Edge]:
    """``links``, from devices to the rules that give them the name: those of the tree, and those that are used."""
    links = [link for link in udev.links if link.is_fixed and link.rule.judged]
    for node in nodes:
        if node.kind == "device":
            for link in udev.links_to(node.name):
                yield _link(Node("device", node.name), link)
    for link in links:
        if link.is_fixed:
            yield _link(Node("device", link.path), link)


def _link(device: Node, link: Link) -> Edge:
    return Edge("links", device, rule_node(link), link.name.span, "SYMLINK+=")


def rule_node(link: Link) -> Node:
    return Node("udev-rule", f"{link.rule.source.basename}:{link.rule.line.span.line}", link.rule.source.name)


def rule_places(udev: Udev) -> Iterator[tuple[Node, Span]]:
    """Where the rules that make links are; a fixed link is where its device gets the name."""
    for link in udev.links:
        if link.rule.judged:
            yield rule_node(link), link.rule.line.span
            if link.is_fixed:
                yield Node("device", link.path), link.name.span
