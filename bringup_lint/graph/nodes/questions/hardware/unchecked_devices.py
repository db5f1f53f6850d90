"""Devices whose failure neither the source that opens them notices nor its header."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.model.cpp_driver import UncheckedDevice
from bringup_lint.parsers.cpp_driver.unchecked_devices import is_asked

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes


def unchecked_devices(nodes: Nodes) -> Iterator[UncheckedDevice]:
    for driver in nodes.drivers:
        for each in driver.unchecked_devices:
            if not is_asked(with_header(nodes, driver.source), each.name):
                yield each
