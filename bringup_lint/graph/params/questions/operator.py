"""What parameter files make of the person who drives a robot: twist_mux and teleop_twist_joy."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import islice
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.launch.started import literal_text
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_MUX = "twist_mux"
_OPERATOR = regex(
    r"(?:^|[_/])(?:joy\w*?|tele\w*?|keyboard|key|manual|operator|rc|remote|gamepad|xbox\w*?|ps[345])(?:$|[_/])"
)
_AUTONOMY = regex(
    r"(?:^|[_/])(?:nav2?|navigation|navigator|auto\w*?|planner|follow\w*?|pursuit|patrol|explore)(?:$|[_/])"
)
_MOST = 200
"""Inputs of a multiplexer that are compared with each other."""
_STOP = regex(r"(?:^|[_/])(?:e_?stop|stop|emergency\w*?|safety|safe)(?:$|[_/])")

_EMERGENCY = regex(r"(?:^|[_/])(?:e_?stop|emergency\w*?)(?:$|[_/])")
_LOOP = regex(r"(?:^|[_/])loop(?:$|[_/])")
"""The lock of the sample of twist_mux that holds navigation back while the map closes a loop."""

_TELEOP = "teleop_twist_joy"
_JOYSTICK = regex(r"joy|tele|pad|\*")
"""What a node is called that drives by a joystick, or what stands for any name."""


class OperatorProblem(NamedTuple):
    kind: str
    """``order``, ``never``, ``endless``, ``lock`` or ``deadman``."""
    where: Span
    name: str
    """The input or lock of the multiplexer; for ``deadman`` the package, where it is known."""
    other: str
    """The input that gets through instead, or in spite of it."""
    detail: str
    related: Span | None = None


@dataclass(frozen=True, slots=True)
class _Input:
    """A topic of velocities, or a lock."""

    name: str
    topic: str
    priority: int
    place: Span
    timeout: float | None
    timed: Span | None

    def fits(self, pattern: re.Pattern[str]) -> bool:
        return any(pattern.search(word) is not None for word in (self.name, self.topic))


def operator_problems(params: Params) -> Iterator[OperatorProblem]:
    """Source: twist_mux.cpp and topic_handle.hpp of twist_mux, teleop_twist_joy.cpp."""
    for file in params.judged:
        if file.accepted and not file.uncertain and params.is_used(file):
            for block in file.blocks:
                yield from _deadman(params, file, block)
                if _is_mux(params, file, block):
                    yield from _mux(block)


def _deadman(params: Params, file: ParameterFile, block: Block) -> Iterator[OperatorProblem]:
    named = {str(each.name): each for each in block.parameters}
    switch = named.get("require_enable_button")
    moves = any(name.startswith("scale_") for name in named)
    if switch is None or switch.value.data is not False or not moves:
        return
    loads = params.loads(file)
    sure = _TELEOP in str(block.key) or any(literal_text(load.node.package) == _TELEOP for load in loads)
    sure = sure or (not loads and _is_named_with(params, block.node_name, _TELEOP))
    if not sure and _JOYSTICK.search(str(block.key)) is None:
        return
    if not loads or params.effective(file, switch):
        yield OperatorProblem("deadman", switch.span, _TELEOP if sure else "", "", "")


def _is_named_with(params: Params, node: str, package: str) -> bool:
    """Whether a launch file names a node and a package, as one does that starts nodes in a way that is not followed."""
    if not params.files.of_kind(*LAUNCH):
        return False
    named = regex(rf"[\"']{re.escape(node)}[\"']")
    texts = (each.source.uncommented for each in params.launch().judged)
    return any(package in text and named.search(text) is not None for text in texts)


def _is_mux(params: Params, file: ParameterFile, block: Block) -> bool:
    if _MUX in str(block.key):
        return True
    packages = {str(literal_text(load.node.package)) for load in params.loads(file)}
    return packages == {_MUX}


def _mux(block: Block) -> Iterator[OperatorProblem]:
    topics, locks = (list(islice(_inputs(block, group), _MOST)) for group in ("topics", "locks"))
    yield from _order(topics)
    for each in topics:
        lower = [other for other in topics if 0 < other.priority < each.priority]
        if each.priority == 0:
            yield OperatorProblem("never", each.place, each.name, "", "")
        elif each.timeout == 0 and each.timed is not None and lower:
            yield OperatorProblem("endless", each.timed, each.name, lower[0].name, "", lower[0].place)
    for lock in locks:
        through = [each for each in topics if each.priority >= lock.priority and _is_held_by(lock, each)]
        if through:
            first = through[0]
            detail = f"{first.priority}, {lock.priority}"
            yield OperatorProblem("lock", lock.place, lock.name, first.name, detail, first.place)


def _order(topics: list[_Input]) -> Iterator[OperatorProblem]:
    """The input of the person that has most to say, where navigation does not give way to it."""
    people = [each for each in topics if each.fits(_OPERATOR)]
    machines = [each for each in topics if each.fits(_AUTONOMY) and each not in people]
    if not people or not machines:
        return
    person, machine = max(people, key=_priority), max(machines, key=_priority)
    unknown = [each for each in topics if each not in people and each not in machines and not each.fits(_STOP)]
    if any(each.priority > machine.priority for each in unknown):
        return  # a person may send it
    if 0 < person.priority < machine.priority:
        detail = f"{machine.priority}, {person.priority}"
        yield OperatorProblem("order", person.place, person.name, machine.name, detail, machine.place)


def _is_held_by(lock: _Input, each: _Input) -> bool:
    """Whether a lock is there to hold back an input: one that is no emergency stop leaves the person alone."""
    if each.fits(_STOP) or not lock.fits(_STOP) or lock.fits(_AUTONOMY) or lock.fits(_LOOP):
        return False
    return lock.fits(_EMERGENCY) or not each.fits(_OPERATOR)


def _priority(each: _Input) -> int:
    return each.priority


def _inputs(block: Block, group: str) -> Iterator[_Input]:
    named = {str(each.name): each for each in block.parameters}
    for name, each in named.items():
        prefix, _, last = name.rpartition(".")
        if last != "priority" or not prefix.startswith(f"{group}.") or not isinstance(each.value.data, int):
            continue
        topic, timeout = named.get(f"{prefix}.topic"), named.get(f"{prefix}.timeout")
        yield _Input(
            prefix.partition(".")[2],
            str(topic.value.data) if topic is not None else "",
            each.value.data,
            each.span,
            _number(timeout),
            timeout.span if timeout is not None else None,
        )


def _number(parameter: Parameter | None) -> float | None:
    value = parameter.value.data if parameter is not None else None
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else None
