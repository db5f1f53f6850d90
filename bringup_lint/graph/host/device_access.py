"""Whether a service may open the devices that its files name: the node's group against the user's groups."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.graph.host.devices import DeviceUse
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.udev.rule import Link
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.model.params import ParameterFile
    from bringup_lint.robot import Robot

_DEFAULT_GROUP = {"tty": "dialout", "video4linux": "video", "input": "input", "sound": "audio"}
"""The groups of 50-udev-default.rules of Debian and Ubuntu; their nodes have mode 0660."""


class ClosedDevice(NamedTuple):
    """A device that the user of a service may not open."""

    unit: Unit
    user: Located
    use: DeviceUse
    link: Link
    group: str


def closed_devices(robot: Robot) -> Iterator[ClosedDevice]:
    """The devices whose group neither /etc/group nor SupplementaryGroups= gives to the user of the service."""
    for unit in robot.units.services:
        user = unit.get("User")
        groups = robot.accounts.groups_of(str(user)) if user and "%" not in user else None
        if groups is None or user in ("root", "0") or unit.get("DynamicUser") or unit.get("PAMName"):
            continue
        own = groups | set(unit.words("SupplementaryGroups")) | {str(unit.get("Group") or "")}
        privileged = any("+" in process.prefixes for process in robot.units.started(unit))
        if "root" in own or privileged:
            continue
        read = _sources(robot, unit)
        for use in robot.devices.uses:
            if use.certainty == "literal" and id(use.path.span.source) in read:
                for link in robot.udev.links_to(use.path)[:1]:
                    group = _group(link)
                    if group and group not in own:
                        yield ClosedDevice(unit, user, use, link, group)


def _sources(robot: Robot, unit: Unit) -> set[int]:
    """The files (by ``id``) that decide what a service opens: its own, its environment files, what it launches."""
    found = {id(file.source) for file in unit.files}
    found |= {id(file.source) for file in robot.units.environment_files(unit) if file.source}
    for process in robot.units.started(unit):
        for _, ros in process.launches:
            entry = robot.launch.named(ros.package, ros.target)
            if entry is not None:
                expansion = robot.launch.expansion(entry)
                found |= {id(file.source) for file in expansion.files}
                found |= {id(file.source) for file in robot.params.judged if _gets(robot, file, expansion)}
    return found


def _gets(robot: Robot, file: ParameterFile, expansion: Expansion) -> bool:
    """Whether a node that the launch file starts is given a parameter file."""
    actions = {id(node.action) for node in expansion.nodes}
    return any(load.certain and id(load.node.action) in actions for load in robot.params.loads(file))


def _group(link: Link) -> str | None:
    """The group that alone may open the node; None when everybody may, or nobody can tell."""
    rule = link.rule
    mode, group = rule.line.first("MODE"), rule.line.first("GROUP")
    if not link.is_fixed or (mode is not None and not _is_closed(mode.value)):
        return None
    if group is not None and not group.has_substitution:
        return str(group.value)
    if group is not None or mode is not None or rule.line.first("OWNER") or rule.line.first("TAG"):
        return None
    kinds = {_DEFAULT_GROUP.get(subsystem) for subsystem in rule.subsystems}
    return kinds.pop() if len(kinds) == 1 else None


def _is_closed(mode: str) -> bool:
    """Whether a mode keeps others out and lets the group read and write."""
    return mode.isdigit() and set(mode) <= set("01234567") and not int(mode, 8) & 0o006 and bool(int(mode, 8) & 0o060)
