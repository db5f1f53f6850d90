"""DDS configuration, compared with the network that netplan makes on the same robot."""

from __future__ import annotations

import re
from collections.abc import Iterable
from collections.abc import Iterator
from ipaddress import ip_network
from typing import TYPE_CHECKING

from bringup_lint.addresses import parse_network
from bringup_lint.graph.dds.cyclonedds_discovery import INTERFACE
from bringup_lint.graph.dds.cyclonedds_discovery import is_loopback_interface
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.cyclonedds import Setting
from bringup_lint.pattern import regex
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.addresses import Address
    from bringup_lint.addresses import Network
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.netplan import Interface
    from bringup_lint.model.netplan import Netplan
    from bringup_lint.model.netplan import Plan

KERNEL_MADE = ("docker", "br-", "veth", "tun", "tap", "wg", "can", "vcan", "tailscale", "zt", "usb", "l4tbr")
"""Beginnings of names that other programs or the kernel give to interfaces without netplan."""
OVERLAY = ip_network("100.64.0.0/10")
"""The addresses of RFC 6598, from which overlay networks take theirs."""

_VPN = regex(
    r"(?:^|/)(?:wireguard|openvpn|zerotier-one|nebula|tinc|swanctl)/|(?:^|/)(?:wg\d*|ipsec)\.conf$|\.ovpn$"
    r"|(?:^|/)(?:wg-quick|openvpn|zerotier-one|nebula)\b[^/]*\.service(?:\.d)?(?:/|$)"
)
"""Files and folders of programs that make an interface of their own, with routes."""


def plan_of(netplan: Netplan, source: Source) -> Plan | None:
    """The netplan of the robot that a file belongs to: the only plan of the tree, below the same root."""
    plan = netplan.only_plan
    if plan is None or not plan.whole or source.robot_path is None:
        return None
    from bringup_lint.model.netplan import root_of

    if plan.has_templates:
        return None
    return plan if plan.roots == {root_of(source)} else None


def named_interfaces(domain: Domain) -> Iterator[Setting]:
    """The interfaces that a Domain block names, one setting each; loopback and variables are left out."""
    for element in domain.found(INTERFACE):
        name = domain.of(element, "name")
        if name is not None and name.effective and not is_loopback_interface(name.effective):
            yield name
    old = domain.get("General/NetworkInterfaceAddress")
    if old is not None and _is_one_name(old.effective or ""):
        yield old


def _is_one_name(text: str) -> bool:
    """Whether NetworkInterfaceAddress names one interface other than loopback."""
    return text[:1].isalpha() and "," not in text and text.lower() not in ("auto", "lo")


def interface_of_device(plan: Plan, name: str) -> Interface | None:
    """The netplan interface whose device has this name."""
    return plan.devices.get(name)


def may_exist(plan: Plan, name: str) -> bool:
    """Whether an interface of this name may come from a match, another program, or the kernel."""
    from fnmatch import fnmatch

    if name.startswith(KERNEL_MADE):
        return True
    for interface in plan.matched:
        pattern = interface.match.name if interface.match else None
        if pattern is None or fnmatch(name, str(pattern)):
            return True
    return False


def networks(interface: Interface) -> list[Network]:
    return [address.ip.network for address in interface.addresses if address.ip is not None]


def subnets(plan: Plan) -> list[tuple[Interface, Network]]:
    """Every interface with each of its networks."""
    return [(each, network) for each in plan.interfaces.values() for network in networks(each)]


def interface_with(plan: Plan, address: Address) -> Interface | None:
    """The interface that has this static address."""
    return plan.by_address.get(str(address))


def own_addresses(plan: Plan) -> set[str]:
    """The static addresses of the robot; empty when an interface gets more by DHCP."""
    return set() if plan.is_dynamic else set(plan.by_address)


def makes_tunnels(files: Files) -> bool:
    """Whether a VPN is set up on the robot, whose interface and routes netplan does not know."""
    return any(_VPN.search(path) for path in files.tree.paths)


def is_routed(plan: Plan, address: Address) -> bool:
    """Whether a route or a subnet of any interface covers an address, or an overlay network such as Tailscale does,
    whose interface netplan does not make."""
    if plan.is_dynamic or address in OVERLAY:
        return True
    for interface in plan.interfaces.values():
        if any(address in network for network in networks(interface)):
            return True
        for route in interface.routes:
            if route.is_default:
                return True
            to = route.value("to")
            network = parse_network(to) if to is not None else None
            if to is not None and (network is None or address in network):
                return True
        if interface.value("gateway4") or interface.value("gateway6"):
            return True
    return False


def waits_for(units: Units, runners: Iterable[Runner], name: str) -> bool:
    """Whether one of the runners, or the waiter of networkd, waits for the interface of this name."""
    for runner in runners:
        if runner.unit is not None and _is_ordered_after(runner.unit, name):
            return True
        if any(_names(text, name) for line in runner.lines for text in line.texts):
            return True
    waiters = (unit for unit in units.judged if "wait-online" in unit.name)
    return any(_names(value, name) for unit in waiters for value in unit.values("ExecStart", "Service"))


def _names(text: str, name: str) -> bool:
    """Whether a text has the name of an interface as a word."""
    return name in text and re.search(rf"(?<![\w.-]){re.escape(name)}(?![\w-])", text) is not None


def _is_ordered_after(unit: Unit, name: str) -> bool:
    """Whether a unit waits for the device unit of an interface, or for its instance of the waiter."""
    device = f"sys-subsystem-net-devices-{name}.device"
    ordered = (word for key in ("After", "BindsTo", "Requires") for word in unit.words(key))
    return any(word == device or f"wait-online@{name}." in word for word in ordered)
