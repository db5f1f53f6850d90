"""Devices that two nodes of one program open at the same time."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.started import Started
from bringup_lint.graph.launch.started import exclusive
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.launch import Launch

_ALONE = regex(
    r"/dev/(?!i2c|spi|gpio|mem|input|dri|null|zero|shm|bus|urandom|snd|nv|net|can\d"
    r"|pps|ptp|rtc|hailo|apex|accel|kfd)[\w./:-]+\Z"
)
"""Devices that one process uses at a time; several may share a bus, a GPIO chip, a clock, an accelerator."""


class Shared(NamedTuple):
    path: Located
    """What the second node is given."""
    first: Located
    node: Started
    other: Started


def shared_devices(launch: Launch) -> Iterator[Shared]:
    """The same device as the same parameter of two nodes, each place once."""
    found: set[tuple[str, int]] = set()
    for expansion in launch.entries:
        opened: dict[tuple[str, str, str, str], list[tuple[Started, Located]]] = {}
        for node in expansion.nodes:
            for key, path in _devices(node):
                program = (literal_text(node.package) or "", literal_text(node.executable) or "")
                before = opened.setdefault((*program, key, path), [])
                other = next(((each, one) for each, one in before if not exclusive(each, node)), None)
                if other is not None and _key(path) not in found and _key(path) != _key(other[1]):
                    found.add(_key(path))
                    yield Shared(path, other[1], node, other[0])
                before.append((node, path))


def _devices(node: Started) -> Iterator[tuple[str, Located]]:
    """The parameters of a node that starts in any case, as the launch file gives them."""
    if not node.is_node or node.by_default is not True or node.conditions or literal_text(node.executable) is None:
        return
    for name, value in node.given:
        key, path = literal_text(name), literal_text(value)
        if key is not None and path is not None and _ALONE.match(path):
            yield key, path


def _key(path: Located) -> tuple[str, int]:
    return (path.span.source.name, path.span.start)
