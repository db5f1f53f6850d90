"""Edges that no line states: systemd.unit(5), "Implicit Dependencies" and "Default Dependencies" there and
in the man page
of each unit type."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.parsers.systemd_values import escape_path
from bringup_lint.parsers.systemd_values import parse_bool

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.dependencies import Instance
    from bringup_lint.graph.systemd.units import Units

_GROUPING_TARGET = {"socket": "sockets.target", "timer": "timers.target", "path": "paths.target"}
_TRIGGERS = {"timer": "Timer", "path": "Path", "socket": "Socket"}
_NETWORK_MOUNTS = frozenset(
    {
        "nfs",
        "nfs4",
        "cifs",
        "smb3",
        "smbfs",
        "sshfs",
        "fuse.sshfs",
        "ceph",
        "glusterfs",
        "9p",
        "davfs",
        "ncpfs",
        "ncp",
    }
)
_FOLDERS = ("WorkingDirectory", "RootDirectory")


def has_default_dependencies(unit: Unit) -> bool:
    value = unit.get("DefaultDependencies", "Unit")
    return value is None or parse_bool(value) is not False


def implicit_edges(instance: Instance, units: Units) -> Iterator[Edge]:
    """What systemd adds to a unit of the tree by its type and settings."""
    unit, here = instance.unit, instance.node
    enabled = has_default_dependencies(unit)
    yield from default_edges(here, enabled)
    yield from _mounts(instance, units)
    if unit.type in _TRIGGERS:
        yield from _trigger(instance, units)
    if unit.type == "timer" and enabled and unit.has("OnCalendar"):
        for clock in ("time-set.target", "time-sync.target"):
            yield _after(here, clock, "implicit: a timer with OnCalendar= is ordered after the clock is set")
    if unit.type == "mount":
        yield from _mount(unit, here, enabled)
    if unit.type == "service":
        yield from _service(instance, units)
    slice_name = unit.get("Slice")
    if slice_name and "%" not in slice_name:
        yield Edge("requires", here, _sibling(here, slice_name), slice_name.span, "Slice=")
        yield Edge("orders", _sibling(here, slice_name), here, slice_name.span, "Slice=")


def _sibling(here: Node, name: str) -> Node:
    """A unit of the same manager."""
    return Node(here.kind, str(name))


def _after(here: Node, name: str, why: str) -> Edge:
    return Edge("orders", _sibling(here, name), here, None, why)


def _service(instance: Instance, units: Units) -> Iterator[Edge]:
    from bringup_lint.graph.systemd.dependencies import targets

    unit, here = instance.unit, instance.node
    for there, span in targets(instance, units, unit.words("Sockets")):
        yield Edge("wants", here, there, span, "Sockets=")
        yield Edge("orders", there, here, span, "Sockets=")
    if unit.get("Type") == "dbus":
        yield Edge("requires", here, _sibling(here, "dbus.socket"), None, "implicit: Type=dbus")
        yield _after(here, "dbus.socket", "implicit: Type=dbus")
    if unit.manager == "system" and parse_bool(unit.get("PrivateTmp") or "no"):
        yield _after(here, "systemd-tmpfiles-setup.service", "implicit: PrivateTmp=")


def _mounts(instance: Instance, units: Units) -> Iterator[Edge]:
    """The mount units of the tree that a path needs, by RequiresMountsFor= and the settings that imply it."""
    from bringup_lint.graph.systemd.dependencies import resolve

    unit, here = instance.unit, instance.node
    wanted = [(word, "RequiresMountsFor=", "requires") for word in unit.words("RequiresMountsFor")]
    wanted += [(word, "WantsMountsFor=", "wants") for word in unit.words("WantsMountsFor")]
    for key in _FOLDERS:
        value = unit.get(key)
        if value and value.startswith("/"):
            wanted.append((value, f"implicit: {key}=", "requires"))
    if unit.type == "mount":
        parent = (unit.get("Where") or "").rstrip("/").rpartition("/")[0]
        wanted.append((parent, "implicit: a mount requires the mount above it", "requires"))
    for path, why, kind in wanted:
        for folder in _upwards(path):
            name = f"{escape_path(folder)}.mount"
            there = resolve(name, unit, units) if units.candidates(name, unit.manager) else None
            if there and there != here:
                where = None if why.startswith("implicit") else path.span
                yield Edge(kind, here, there, where, why)
                yield Edge("orders", there, here, where, why)


def _upwards(path: str) -> Iterator[str]:
    while path.startswith("/"):
        yield path or "/"
        path = path.rstrip("/").rpartition("/")[0]


def _mount(unit: Unit, here: Node, enabled: bool) -> Iterator[Edge]:
    if not enabled:
        return
    options = (unit.get("Options") or "").split(",")
    network = unit.get("Type") in _NETWORK_MOUNTS or "_netdev" in options
    why = "implicit: default dependency of a mount"
    yield _after(here, "remote-fs-pre.target" if network else "local-fs-pre.target", why)
    if network:
        yield Edge("wants", here, _sibling(here, "network-online.target"), None, why)
        for name in ("network-online.target", "network.target"):
            yield _after(here, name, why)
    if "nofail" not in options:
        yield Edge("orders", here, _sibling(here, "remote-fs.target" if network else "local-fs.target"), None, why)


def _trigger(instance: Instance, units: Units) -> Iterator[Edge]:
    """The unit that a timer, path or socket starts, which is ordered after it."""
    from bringup_lint.graph.systemd.dependencies import resolve
    from bringup_lint.graph.systemd.dependencies import targets

    unit, here = instance.unit, instance.node
    key = "Service" if unit.type == "socket" else "Unit"
    named = unit.get(key, _TRIGGERS[unit.type])
    if named:
        ends = list(targets(instance, units, [named]))
    elif unit.type == "socket" and parse_bool(unit.get("Accept") or "no"):
        return
    else:
        there = resolve(f"{instance.name.rpartition('.')[0]}.service", unit, units)
        ends = [(there, unit.where)] if there else []
    for there, span in ends:
        why = f"{key}=" if named else f"implicit: a {unit.type} is ordered before the service that it starts"
        yield Edge("triggers", here, there, span, why)
        yield Edge("orders", here, there, span if named else None, why)


def default_edges(here: Node, enabled: bool) -> Iterator[Edge]:
    """DefaultDependencies=yes: what every unit of the type has. The user manager has no sysinit.target."""
    if not enabled:
        return
    kind = here.name.rpartition(".")[2]
    reason = f"implicit: default dependency of a {kind}"
    system = here.kind == "unit"
    if kind in (("service", "socket", "timer", "path") if system else ("service",)):
        base = "sysinit.target" if system else "basic.target"
        yield Edge("requires", here, _sibling(here, base), None, reason)
        yield _after(here, base, reason)
    if kind == "service" and system:
        yield _after(here, "basic.target", reason)
    if kind in _GROUPING_TARGET:
        yield Edge("orders", here, _sibling(here, _GROUPING_TARGET[kind]), None, reason)


def after_members(graph: Graph, units: Units) -> Iterator[Edge]:
    """A target is ordered after what it wants or requires, unless one side says otherwise
    (systemd.target(5))."""
    without = {units.node(unit) for unit in units.all if unit.fragment and not has_default_dependencies(unit)}
    if not units.has_vendor_units:
        from bringup_lint.facts import table

        own = {unit.name for unit in units.all if unit.manager == "system"}
        without |= {
            Node("unit", row["unit"])
            for row in table("systemd/units")
            if row["default_dependencies"] == "no" and row["unit"] not in own
        }
    for target, edges in list(graph.out.items()):
        if not target.name.endswith(".target") or target in without:
            continue
        ordered = {edge.target for edge in edges if edge.kind == "orders"}
        ordered |= {edge.source for edge in graph.into.get(target, ()) if edge.kind == "orders"}
        for edge in edges:
            if (
                edge.kind in ("wants", "requires", "binds-to")
                and edge.target not in ordered
                and edge.target not in without
            ):
                why = f"implicit: {target.name} is ordered after the units that it pulls in"
                why = f"{why} ({edge.why})" if edge.where else why
                yield Edge("orders", edge.target, target, edge.where, why, edge.of_package)
                ordered.add(edge.target)
