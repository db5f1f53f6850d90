"""Processes of one robot that have different values of a variable, and values that overrule others on their way."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.graph.commands.environment import Variable
from bringup_lint.graph.environment.ros import RosEnvironment
from bringup_lint.graph.environment.ros import RosProcess
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Source
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.unit import Unit

_OF_SHELL = ("export", "shell", "declare", "typeset", "readonly")
_BRIDGE = regex(r"(?<!ros)(?<!ros[-_])bridge|domain", re.I)
"""Names of what may join two domains; rosbridge only talks to browsers."""
_DOMAIN_BRIDGE = regex(r"\b(?:domain_bridge|ddsrouter|dds-router|zenoh-bridge-(?:dds|ros2dds))\b")
"""Programs that pass topics from one domain to another."""


class Valued(NamedTuple):
    """A process, and the variable that it ends up with."""

    process: RosProcess
    variable: Variable


class Different(NamedTuple):
    """A process with another value than most processes of its robot have."""

    one: Valued
    usual: Valued


class Overridden(NamedTuple):
    """A value that does not reach a process, because another one is set after it."""

    by: Valued
    hidden: Variable
    launcher: RosProcess | None
    """The process that has the hidden value, where a launch file sets the other one; else the shell of a unit does."""


def conflicts(ros: RosEnvironment, name: str) -> Iterator[Different | Overridden]:
    """The conflicts about a variable in each robot."""
    for processes in _robots(ros):
        found = [Valued(process, variable) for process in processes if (variable := _known(process, name))]
        yield from _overridden_by_shell(name, found)
        values: dict[str | None, list[Valued]] = {}
        for each in found:
            values.setdefault(each.variable.text, []).append(each)
        if len(values) < 2:
            yield from _overridden_by_launch(name, found)
        elif name != "ROS_DOMAIN_ID" or not any(_DOMAIN_BRIDGE.search(each.source.said) for each in processes):
            yield from _different(list(values.values()))


def _different(values: list[list[Valued]]) -> Iterator[Different]:
    usual = max(values, key=len)
    for users in values:
        pair = _pair(users, usual) if users is not usual else None
        if pair is None:
            continue
        same_file = pair.one.variable.value.span.source is pair.usual.variable.value.span.source
        if not (pair.one.process.launched and same_file):
            yield pair


def _pair(users: list[Valued], usual: list[Valued]) -> Different | None:
    """The first two that run together; services of different profiles of compose never do."""
    from bringup_lint.model.compose import Beside

    beside = Beside(other.process.service for other in usual)
    for one in users:
        first = beside.first(one.process.service)
        if first is not None:
            return Different(one, usual[first])
    return None


def _overridden_by_launch(name: str, found: Iterable[Valued]) -> Iterator[Overridden]:
    """Launch files that give a whole robot another value than its unit or service says."""
    seen: set[tuple[Source, int]] = set()
    for each in found:
        process, span = each.process, each.variable.value.span
        others = [known for known in process.environment.chain(name) if known.text]
        before = [known for known in others if known.text != each.variable.text]
        if process.launcher is None or not before or (span.source, span.start) in seen:
            continue
        if before[-1].value.span.source is not span.source:
            seen.add((span.source, span.start))
            yield Overridden(each, before[-1], process.launcher)


def _overridden_by_shell(name: str, found: Iterable[Valued]) -> Iterator[Overridden]:
    """Scripts that set another value than the unit that starts them."""
    seen = set()
    for each in found:
        process, variable = each
        if process.unit is None or process.launcher is not None or variable.origin not in _OF_SHELL:
            continue
        before = [known for known in process.environment.chain(name) if known.origin not in _OF_SHELL and known.text]
        if variable not in seen and before and before[-1].text != variable.text:
            seen.add(variable)
            yield Overridden(each, before[-1], None)


def _known(process: RosProcess, name: str) -> Variable | None:
    variable = process.environment.get(name)
    if variable is None or not variable.text or _BRIDGE.search(process.name):
        return None
    return variable


def _robots(ros: RosEnvironment) -> Iterable[list[RosProcess]]:
    """Processes that certainly belong to one robot: units that do, services of one compose file, their nodes."""
    units = {process.unit: None for process in ros.processes if process.unit}
    groups = ros.units().same_robot_groups(units) if units else []
    group_of = {unit: number for number, group in enumerate(groups) for unit in group}
    found: dict[object, list[RosProcess]] = {}
    for process in ros.processes:
        by_hand = process.launched and process.launcher is None
        if by_hand or (process.launched and ros.is_development(process.where)):
            continue
        key: object = group_of[process.unit] if process.unit else (process.launcher or process).source.name
        if len(groups) == 1 and _starts_beside(ros, process, groups[0]):
            key = 0
        found.setdefault(key, []).append(process)
    return found.values()


def _starts_beside(ros: RosEnvironment, process: RosProcess, units: Iterable[Unit]) -> bool:
    """Whether a service of the only compose file runs on the network of the robot whose only units these are: docker
    starts it at boot, as systemd starts them."""
    service = process.service
    if service is None or not service.is_on_host_network or len(ros.compose().files) != 1:
        return False
    boots = service.restart in ("always", "unless-stopped")
    return boots and all(ros.files.same_robot(service.source, unit.where.source) for unit in units)
