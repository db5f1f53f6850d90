"""Stop commands after a spin that a signal ends with an exception."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.facts.ros.pin_libraries import PIN_LIBRARIES
from bringup_lint.graph.nodes.questions.ending.stopping import default_signals
from bringup_lint.graph.nodes.sources.ending import Ending
from bringup_lint.graph.nodes.sources.ending import Spin
from bringup_lint.graph.nodes.sources.motion import is_remote
from bringup_lint.graph.nodes.sources.motion import is_velocity
from bringup_lint.graph.nodes.sources.motion import moves
from bringup_lint.graph.nodes.sources.sending import called
from bringup_lint.graph.nodes.sources.sending import published
from bringup_lint.graph.nodes.sources.syntax import body_of
from bringup_lint.graph.nodes.sources.syntax import own_calls
from bringup_lint.model.node_source import NodeClass
from bringup_lint.model.node_source import NodeSource
from bringup_lint.model.python import written
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

DEPTH = 3
"""Methods and functions that are looked into from the statement after the spin."""
_HARDWARE = regex(rf"(?:{'|'.join(PIN_LIBRARIES)}|serial|can|spidev|dynamixel_sdk)\b")
"""Modules that reach motors and pins."""
_STOPS = regex(
    r"(?i)(?:stop|halt|brake|disarm|zero)(?:_?(?:all|motors?|robot|wheels?|moving|motion|drive|thrusters?))?"
    r"|(?:motors?|all|robot|wheels?|emergency|e)_?(?:stop|off)|off|turn_off|cleanup|disable(?:_?(?:motors?|torque|all))?"
    r"|set_?(?:motors?|speeds?|pwm|throttle|velocity|duty\w{0,10})|output|write\w{0,20}|sendall|send"
)
"""Names of methods by which hardware is stopped, or told anything at all."""
_LATER = regex(
    r"\batexit\.register\b|\.on_shutdown\(|\bweakref\.finalize\b|def __del__\b",
    hints="atexit.register .on_shutdown( weakref.finalize __del__",
)
"""What runs at the end of the context or of the process all the same."""
_OTHERS = regex(
    r"(?i)executor|thread|timer|server|recorder|bag|file|log|sys\b|std(?:out|err)|cap\b|camera|pipeline|proc"
)


class UnreachedStop(NamedTuple):
    file: NodeSource
    stop: ast.Call
    """The call after the spin that leads to the stop."""
    spin: Spin
    is_motion: bool
    """It is a velocity that is published."""


def unreached_stops(nodes: Nodes) -> Iterator[UnreachedStop]:
    """The first stop command after each spin that no ``try`` surrounds, where rclpy handles the signals."""
    for file in nodes.robot_sources:
        ending = nodes.ending(file)
        if not ending.spins or not default_signals(ending) or file.source.matches(_LATER):
            continue
        for spin in ending.spins:
            if not spin.loop and not any(isinstance(outer, ast.Try) for outer, _ in ending.syntax.within(spin.call)):
                yield from _after(ending, spin)


def _after(ending: Ending, spin: Spin) -> Iterator[UnreachedStop]:
    statement = next((outer for outer, _ in ending.syntax.within(spin.call) if isinstance(outer, ast.stmt)), None)
    if not isinstance(statement, ast.Expr):
        return
    is_hardware = any(_HARDWARE.match(name or "") for name in ending.file.imports.values())
    for call in own_calls(ending.syntax.after(statement)):
        found = _stop(ending, call, None, is_hardware, DEPTH)
        if found is not None:
            yield UnreachedStop(ending.file, call, spin, found)
            return


def _stop(ending: Ending, call: ast.Call, cls: NodeClass | None, is_hardware: bool, depth: int) -> bool | None:
    """Whether a call stops something by a message (True) or at the hardware (False); None when it stops nothing."""
    endpoint = published(ending.syntax, call, cls)
    if endpoint is not None:
        return True if moves(endpoint) or is_velocity(endpoint) or is_remote(endpoint) else None
    inside = list(called(ending.syntax, call, cls)) if depth else []
    for function, owner in inside:
        for inner in own_calls(body_of(function)):
            found = _stop(ending, inner, owner, is_hardware, depth - 1)
            if found is not None:
                return found
    return False if not inside and is_hardware and _stops_hardware(call) else None


def _stops_hardware(call: ast.Call) -> bool:
    function = call.func
    if not isinstance(function, ast.Attribute) or not _STOPS.fullmatch(function.attr):
        return False
    return not _OTHERS.search(written(function.value))
