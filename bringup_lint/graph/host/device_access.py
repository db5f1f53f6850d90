"""Whether a service may open the devices that its files name: the node's group against the user's groups."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.host.device_uses import DeviceUse
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.udev.rule import Link
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.host.accounts import Accounts
    from bringup_lint.graph.host.devices import Devices
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.params import ParameterFile

_DEFAULT_GROUP = {"tty": "dialout", "video4linux": "video", "input": "input", "sound": "audio"}
"""The groups of 50-udev-default.rules of Debian and Ubuntu; their nodes have mode 0660."""


class ClosedDevice(NamedTuple):
    """A device that the user of a service may not open."""

    unit: Unit
    user: Located
    use: DeviceUse
    link: Link
    group: str


def closed_devices(
    devices: Devices, units: Units, accounts: Accounts, launch: Callable[[], Launch], params: Callable[[], Params]
) -> Iterator[ClosedDevice]:
    """The devices whose group neither /etc/group nor SupplementaryGroups= gives to the user of the service."""
    for unit in units.services:
        user = unit.get("User")
        own = _groups(unit, units, accounts)
        if user is None or own is None:
            continue
        read = _sources(unit, units, launch, params)
        for use in devices.uses:
            if use.certainty == "literal" and use.path.span.source in read:
                for link in devices.udev().links_to(use.path)[:1]:
                    group = _group(link)
                    if group and group not in own:
                        yield ClosedDevice(unit, user, use, link, group)


def _groups(unit: Unit, units: Units, accounts: Accounts) -> frozenset[str] | None:
    """The groups of a service that runs as a user of the tree's /etc/passwd; None for root, and when not known."""
    identity = unit.identity
    if identity.name is None or identity.is_root is not False or identity.dynamic or unit.get("PAMName"):
        return None
    groups = accounts.groups_of(identity.name)
    if groups is None:
        return None
    own = identity.groups(units.users)
    privileged = any("+" in process.prefixes for process in units.started(unit))
    return None if "root" in own or privileged else own


def _sources(unit: Unit, units: Units, launch: Callable[[], Launch], params: Callable[[], Params]) -> set[Source]:
    """The files that decide what a service opens: its own, its environment files, what it launches."""
    found = {file.source for file in unit.files}
    found |= {file.source for file in units.environment_files(unit) if file.source}
    for process in units.started(unit):
        for _, ros in process.launches:
            entry = launch().named(ros.package, ros.target)
            if entry is not None:
                expansion = launch().expansion(entry)
                found |= {file.source for file in expansion.files}
                found |= {file.source for file in params().judged if _gets(params(), file, expansion)}
    return found


def _gets(params: Params, file: ParameterFile, expansion: Expansion) -> bool:
    """Whether a node that the launch file starts is given a parameter file."""
    actions = {node.action for node in expansion.nodes}
    return any(load.certain and load.node.action in actions for load in params.loads(file))


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
    return mode.isdecimal() and set(mode) <= set("01234567") and not int(mode, 8) & 0o006 and bool(int(mode, 8) & 0o060)
