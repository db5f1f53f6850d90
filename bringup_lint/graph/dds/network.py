"""DDS configuration held against the network that the same robot's netplan makes."""

from __future__ import annotations

import ipaddress
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.dds.cyclonedds_discovery import INTERFACE
from bringup_lint.graph.dds.cyclonedds_discovery import LOOPBACK
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.cyclonedds import Setting
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.model.netplan import Interface
    from bringup_lint.model.netplan import Plan
    from bringup_lint.robot import Robot

KERNEL_MADE = ("docker", "br-", "veth", "tun", "tap", "wg", "can", "vcan", "tailscale", "zt", "usb", "l4tbr")
"""Beginnings of names that other programs or the kernel give to interfaces without netplan."""


def plan_of(robot: Robot, source: Source) -> Plan | None:
    """The netplan of the robot that a file lies on: the only plan of the tree, below the same root."""
    plan = robot.netplan.only_plan
    if plan is None or not plan.whole or source.robot_path is None:
        return None
    if any(file.source.template for file in plan.files):
        return None
    roots = {_root(file.source) for file in plan.files}
    return plan if roots == {_root(source)} else None


def _root(source: Source) -> str | None:
    path = source.robot_path
    return source.name.removesuffix(path.lstrip("/")) if path and source.name.endswith(path.lstrip("/")) else None


def named_interfaces(domain: Domain) -> Iterator[Setting]:
    """The interfaces that a Domain block names, one setting each; loopback and variables are left out."""
    for element in domain.found(INTERFACE):
        name = domain.of(element, "name")
        if name is not None and name.effective and name.effective not in LOOPBACK:
            yield name
    old = domain.get("General/NetworkInterfaceAddress")
    if (
        old is not None and old.effective and old.effective[0].isalpha() and old.effective.lower() not in ("auto", "lo")
    ) and "," not in old.effective:
        yield old


def device(plan: Plan, name: str) -> Interface | None:
    """The netplan interface whose device has this name."""
    return next((each for each in plan.interfaces.values() if each.device == name), None)


def may_exist(plan: Plan, name: str) -> bool:
    """Whether an interface of this name may come from a match, another program, or the kernel."""
    from fnmatch import fnmatch

    if name.startswith(KERNEL_MADE):
        return True
    for interface in plan.interfaces.values():
        if interface.is_physical and interface.device is None:
            match = interface.match
            pattern = match.name if match else None
            if pattern is None or fnmatch(name, str(pattern)):
                return True
    return False


def networks(interface: Interface) -> list[ipaddress.IPv4Network | ipaddress.IPv6Network]:
    return [address.ip.network for address in interface.addresses if address.ip is not None]


def subnets(plan: Plan) -> list[tuple[Interface, ipaddress.IPv4Network | ipaddress.IPv6Network]]:
    """Every interface with each of its networks."""
    return [(each, network) for each in plan.interfaces.values() for network in networks(each)]


def interface_with(plan: Plan, address: ipaddress.IPv4Address | ipaddress.IPv6Address) -> Interface | None:
    """The interface that has this static address."""
    for interface in plan.interfaces.values():
        if any(each.ip is not None and each.ip.ip == address for each in interface.addresses):
            return interface
    return None


def own_addresses(plan: Plan) -> set[str]:
    """The static addresses of the robot; empty when an interface gets more by DHCP."""
    if any(interface.dhcp4 or interface.dhcp6 for interface in plan.interfaces.values()):
        return set()
    return {str(each.ip.ip) for one in plan.interfaces.values() for each in one.addresses if each.ip is not None}


def routed(plan: Plan, address: ipaddress.IPv4Address | ipaddress.IPv6Address) -> bool:
    """Whether a route or a subnet of any interface covers an address."""
    for interface in plan.interfaces.values():
        if interface.dhcp4 or interface.dhcp6 or any(address in network for network in networks(interface)):
            return True
        for route in interface.routes:
            to = route.value("to")
            try:
                if route.is_default or (to is not None and address in ipaddress.ip_network(str(to), strict=False)):
                    return True
            except ValueError:
                return True
        if interface.value("gateway4") or interface.value("gateway6"):
            return True
    return False


def waits_for(robot: Robot, units: list[Unit], name: str) -> bool:
    """Whether one of the units, or the waiter of networkd, waits for the interface of this name."""
    device = f"sys-subsystem-net-devices-{name}.device"
    own = re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w-])")
    for unit in units:
        ordered = [word for key in ("After", "BindsTo", "Requires") for word in unit.words(key)]
        if any(word == device or f"wait-online@{name}." in word for word in ordered):
            return True
        if any(own.search(text) for process in robot.units.processes(unit) for text in process.texts):
            return True
    waiters = [unit for unit in robot.units.judged if "wait-online" in unit.name]
    return any(own.search(value) for unit in waiters for value in unit.values("ExecStart", "Service"))
