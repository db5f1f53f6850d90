"""Edges that no line states: systemd.unit(5), "Implicit Dependencies" and "Default Dependencies" there and
in the man page
of each unit type."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.facts.systemd.directives import SECTION_OF_TYPE
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.graph import Origin
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.references import Instance
from bringup_lint.graph.systemd.references import resolve
from bringup_lint.graph.systemd.references import targets
from bringup_lint.graph.systemd.shipped_units import without_default_dependencies
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import escape_path
from bringup_lint.source import Span

_GROUPING_TARGET = {"socket": "sockets.target", "timer": "timers.target", "path": "paths.target"}
_TRIGGERS = ("timer", "path", "socket")
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
MEMBERS = frozenset({"wants", "requires", "binds-to"})
"""The relations of a target to units after which it starts."""
_FOLDERS = ("WorkingDirectory", "RootDirectory")


def has_default_dependencies(unit: Unit) -> bool:
    return unit.flag("DefaultDependencies", "Unit").value is not False


def implicit_edges(instance: Instance, units: NamedUnits) -> Iterator[Edge]:
    """What systemd adds to a unit of the tree by its type and settings."""
    unit, here = instance.unit, instance.node
    enabled = has_default_dependencies(unit)
    yield from default_edges(here, enabled)
    yield from _mounts(instance, units)
    if unit.type in _TRIGGERS:
        yield from _trigger(instance, units)
    if unit.type == "timer" and enabled and unit.has("OnCalendar"):
        for clock in ("time-set.target", "time-sync.target"):
            yield _after(here, clock, "a timer with OnCalendar= is ordered after the clock is set")
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


def _after(here: Node, name: str, why: str, origin: Origin = Origin.IMPLICIT) -> Edge:
    return Edge("orders", _sibling(here, name), here, None, why, origin=origin)


def _service(instance: Instance, units: NamedUnits) -> Iterator[Edge]:
    unit, here = instance.unit, instance.node
    for there, span in targets(instance, units, unit.words("Sockets")):
        yield Edge("wants", here, there, span, "Sockets=")
        yield Edge("orders", there, here, span, "Sockets=")
    if unit.get("Type") == "dbus":
        yield Edge("requires", here, _sibling(here, "dbus.socket"), None, "Type=dbus", origin=Origin.IMPLICIT)
        yield _after(here, "dbus.socket", "Type=dbus")
    if unit.manager == "system" and unit.flag("PrivateTmp"):
        yield _after(here, "systemd-tmpfiles-setup.service", "PrivateTmp=")


class _NeededPath(NamedTuple):
    """A path that must be mounted before the unit starts."""

    path: str
    kind: str
    why: str
    where: Span | None
    """The line that says so; None for what a setting implies."""

    @property
    def origin(self) -> Origin:
        return Origin.SETTING if self.where else Origin.IMPLICIT


def _needed_paths(unit: Unit) -> Iterator[_NeededPath]:
    for word in unit.words("RequiresMountsFor"):
        yield _NeededPath(word, "requires", "RequiresMountsFor=", word.span)
    for word in unit.words("WantsMountsFor"):
        yield _NeededPath(word, "wants", "WantsMountsFor=", word.span)
    for key in _FOLDERS:
        value = unit.get(key)
        if value and value.startswith("/"):
            yield _NeededPath(value, "requires", f"{key}=", None)
    if unit.type == "mount":
        parent = (unit.get("Where") or "").rstrip("/").rpartition("/")[0]
        yield _NeededPath(parent, "requires", "a mount requires the mount above it", None)


def _mounts(instance: Instance, units: NamedUnits) -> Iterator[Edge]:
    """The mount units of the tree that a path needs, by RequiresMountsFor= and the settings that imply it."""
    unit, here = instance.unit, instance.node
    for needed in _needed_paths(unit):
        for folder in _upwards(needed.path):
            name = f"{escape_path(folder)}.mount"
            there = resolve(name, unit, units) if units.candidates(name, unit.manager) else None
            if there and there != here:
                yield Edge(needed.kind, here, there, needed.where, needed.why, origin=needed.origin)
                yield Edge("orders", there, here, needed.where, needed.why, origin=needed.origin)


def _upwards(path: str) -> Iterator[str]:
    while path.startswith("/"):
        yield path or "/"
        path = path.rstrip("/").rpartition("/")[0]


def _mount(unit: Unit, here: Node, enabled: bool) -> Iterator[Edge]:
    if not enabled:
        return
    options = (unit.get("Options") or "").split(",")
    network = unit.get("Type") in _NETWORK_MOUNTS or "_netdev" in options
    why = "default dependency of a mount"
    yield _after(here, "remote-fs-pre.target" if network else "local-fs-pre.target", why, Origin.DEFAULT)
    if network:
        yield Edge("wants", here, _sibling(here, "network-online.target"), None, why, origin=Origin.DEFAULT)
        for name in ("network-online.target", "network.target"):
            yield _after(here, name, why, Origin.DEFAULT)
    if "nofail" not in options:
        before = "remote-fs.target" if network else "local-fs.target"
        yield Edge("orders", here, _sibling(here, before), None, why, origin=Origin.DEFAULT)


def _trigger(instance: Instance, units: NamedUnits) -> Iterator[Edge]:
    """The unit that a timer, path or socket starts, which is ordered after it."""
    unit, here = instance.unit, instance.node
    key = "Service" if unit.type == "socket" else "Unit"
    named = unit.get(key, SECTION_OF_TYPE[unit.type])
    if named:
        ends = list(targets(instance, units, [named]))
    elif unit.type == "socket" and unit.flag("Accept"):
        return
    else:
        there = resolve(f"{instance.name.rpartition('.')[0]}.service", unit, units)
        ends = [(there, unit.where)] if there else []
    for there, span in ends:
        why = f"{key}=" if named else f"a {unit.type} is ordered before the service that it starts"
        origin = Origin.SETTING if named else Origin.IMPLICIT
        yield Edge("triggers", here, there, span, why, origin=origin)
        yield Edge("orders", here, there, span if named else None, why, origin=origin)


def default_edges(here: Node, enabled: bool) -> Iterator[Edge]:
    """DefaultDependencies=yes: what every unit of the type has. The user manager has no sysinit.target."""
    if not enabled:
        return
    kind = here.name.rpartition(".")[2]
    reason = f"default dependency of a {kind}"
    system = here.kind == "unit"
    if kind in (("service", "socket", "timer", "path") if system else ("service",)):
        base = "sysinit.target" if system else "basic.target"
        yield Edge("requires", here, _sibling(here, base), None, reason, origin=Origin.DEFAULT)
        yield _after(here, base, reason, Origin.DEFAULT)
    if kind == "service" and system:
        yield _after(here, "basic.target", reason, Origin.DEFAULT)
    if kind in _GROUPING_TARGET:
        yield Edge("orders", here, _sibling(here, _GROUPING_TARGET[kind]), None, reason, origin=Origin.DEFAULT)


def after_members(graph: Graph, units: NamedUnits) -> Iterator[Edge]:
    """A target is ordered after what it wants or requires, unless one side says otherwise
    (systemd.target(5))."""
    without = _without_defaults(units)
    for target, edges in list(graph.out.items()):
        if not target.name.endswith(".target") or target in without:
            continue
        ordered = _ordered_with(target, graph)
        for edge in edges:
            if edge.kind in MEMBERS and edge.target not in ordered and edge.target not in without:
                why = f"{target.name} is ordered after the units that it pulls in"
                why = f"{why} ({edge.said})" if edge.where else why
                yield Edge("orders", edge.target, target, edge.where, why, edge.of_package, Origin.IMPLICIT)
                ordered.add(edge.target)


def _without_defaults(units: NamedUnits) -> set[Node]:
    """The units that say DefaultDependencies=no."""
    found = {units.node(unit) for unit in units.all if unit.fragment and not has_default_dependencies(unit)}
    if not units.has_vendor_units:
        own = {unit.name for unit in units.all if unit.manager == "system"}
        found |= {Node("unit", name) for name in without_default_dependencies() if name not in own}
    return found


def _ordered_with(node: Node, graph: Graph) -> set[Node]:
    """The units that are ordered before or after another one, by an edge between the two."""
    after = {edge.target for edge in graph.out.get(node, ()) if edge.kind == "orders"}
    return after | {edge.source for edge in graph.into.get(node, ()) if edge.kind == "orders"}
