"""Pins that are set up before the program says how it counts them."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.declared import mentions
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.model.node_source import NodeSource

_MODULES = ("RPi.GPIO", "Jetson.GPIO")
_SETS_MODE = regex(r"\bsetmode\b|^[ \t]*(?:import|from)[ \t]+(?:board|busio|digitalio|adafruit_\w+|gpiozero)\b", re.M)
"""What sets the mode: the program itself, or Blinka and gpiozero when they are imported."""
_ELSEWHERE = ("setmode", "import board", "adafruit_")
"""The same in another module of the package, which may be imported first."""


def without_pin_mode(nodes: Nodes) -> Iterator[tuple[NodeSource, ast.Call]]:
    """The first ``GPIO.setup`` of the nodes whose package calls ``GPIO.setmode`` nowhere."""
    for file in nodes.robot_sources:
        named = nodes.syntax(file).named
        calls = [call for module in _MODULES for call in named.get(f"{module}.setup", [])]
        if not calls:
            continue
        imported = nodes.imported(file)
        package = nodes.launch.workspace.owner(file.source)
        elsewhere = package is not None and any(mentions(nodes.files, package, word) for word in _ELSEWHERE)
        if imported is not None and not elsewhere and not any(each.source.matches(_SETS_MODE) for each in imported):
            yield file, calls[0]
