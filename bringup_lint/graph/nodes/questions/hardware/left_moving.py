"""Sources of ros2_control hardware that leave their motors as they are when they are deactivated."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.nodes.questions.hardware.hardware_interfaces import LOG
from bringup_lint.graph.nodes.questions.hardware.hardware_interfaces import SIMULATED
from bringup_lint.graph.nodes.questions.hardware.hardware_interfaces import hardware
from bringup_lint.graph.nodes.sources.with_header import with_header
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.nodes.nodes import Nodes

_MOVING = regex(r"\bHW_IF_(?:VELOCITY|EFFORT)\b|\"(?:velocity|effort)\"")
_OF_DESCRIPTION = regex(r"\bcommand_interfaces\s{0,4}\[")
"""The kind of command is that of the robot description."""
_NOT_SIMULATED = regex(r"(?i)!\s{0,4}\w{0,40}(?:simulat|fake|mock)")
_PASSIVE = regex(r"\breturn\b[^;(]{0,200};|\(\s{0,4}void\s{0,4}\)\s{0,4}\w{1,80}\s{0,4};")
_ACTS = regex(r"[(=]|\+\+|--")
_SENDS = regex(r"(?:\.|->|::)\s{0,4}\w{1,80}\s{0,4}\(")
_STOPS = regex(r"(?i)stop|halt|brake|zero|disable|power|torque|estop|free")
_DESTRUCTOR = regex(r"~\w{1,80}\s{0,4}\(\s{0,4}\)[\w\s]{0,40}(?:\{\s{0,40}[^\s}]|;)")
"""A destructor that does something, or is defined elsewhere."""
_STOPS_BY_ITSELF = regex(r"(?i)auto_?stop|watchdog|time_?out|last_?(?:command|cmd|motor)")
_FIRMWARE_FILES = 200


class LeftMoving(NamedTuple):
    source: Source
    place: Span
    """Where ``on_deactivate`` is defined."""
    sends: Span
    """Where ``write()`` sends the command."""


def left_moving(nodes: Nodes) -> Iterator[LeftMoving]:
    """Hardware with commands for velocities or efforts whose ``on_deactivate`` only logs, that nothing else stops."""
    for source, plain, bodies in hardware(nodes):
        exported, body, written = (bodies.get(each) for each in ("export_command_interfaces", "on_deactivate", "write"))
        if exported is None or body is None or written is None or not _is_moved(plain, exported):
            continue
        if _ACTS.search(_PASSIVE.sub("", LOG.sub("", plain[slice(*body)]))):
            continue
        sends = _SENDS.search(LOG.sub(lambda log: " " * len(log[0]), plain[: written[1]]), written[0])
        if sends is None or _is_simulated(plain) or _is_stopped_later(nodes, source, plain, bodies):
            continue
        if not _has_firmware_that_stops(nodes):
            start = plain.rfind("on_deactivate", 0, body[0])
            place = Span(source, start, start + len("on_deactivate"))
            yield LeftMoving(source, place, Span(source, sends.start() + 1, sends.end() - 1))


def _is_moved(plain: str, exported: tuple[int, int]) -> bool:
    if _MOVING.search(plain, *exported):
        return True
    return _OF_DESCRIPTION.search(plain, *exported) is not None and _MOVING.search(plain) is not None


def _is_simulated(plain: str) -> bool:
    return SIMULATED.search(plain) is not None and not _NOT_SIMULATED.search(plain)


def _is_stopped_later(nodes: Nodes, source: Source, plain: str, bodies: dict[str, tuple[int, int]]) -> bool:
    """Whether a later transition stops the motors, or the destructor may."""
    later = (bodies[each] for each in ("on_cleanup", "on_shutdown") if each in bodies)
    if any(_STOPS.search(LOG.sub("", plain[slice(*each)])) for each in later):
        return True
    return _DESTRUCTOR.search(with_header(nodes, source)) is not None


def _has_firmware_that_stops(nodes: Nodes) -> bool:
    """Whether the tree has a firmware that may stop the motors when no command comes."""
    tree = nodes.files.tree
    paths = [each for each in tree.paths if each.endswith(".ino") or "firmware" in os.path.dirname(each)]
    sources = (tree.read(each, judged=False) for each in paths[:_FIRMWARE_FILES])
    return len(paths) > _FIRMWARE_FILES or any(each and each.matches(_STOPS_BY_ITSELF) for each in sources)
