"""Which addresses share a subnet, without a comparison of each with each."""

from __future__ import annotations

from bringup_lint import addresses
from bringup_lint.model.netplan import Address
from bringup_lint.model.netplan import Interface
from bringup_lint.named_tuple import NamedTuple

Network = tuple[int, int, int]
"""IP version, length of the prefix, the prefix as a number."""


class Member(NamedTuple):
    """An address, and where it comes in the order of the files."""

    order: int
    interface: Interface
    address: Address
    ip: addresses.Interface
    host: addresses.Address
    """The address without its network, which ``ipaddress`` makes anew whenever it is asked."""

    def conflicts(self, interface: Interface, host: addresses.Address) -> bool:
        return self.interface is not interface and self.host != host


class Subnets:
    """The addresses so far, by the networks that they are in."""

    def __init__(self) -> None:
        self._exact: dict[Network, list[Member]] = {}
        self._within: dict[Network, list[Member]] = {}
        self._count = 0

    def add(self, interface: Interface, address: Address) -> None:
        """Keep an address that has an ``ip``."""
        if address.ip is None:
            return
        member = Member(self._count, interface, address, address.ip, address.ip.ip)
        self._count += 1
        length = address.ip.network.prefixlen
        _keep(self._exact.setdefault(_network(address.ip, length), []), member)
        for shorter in range(length + 1):
            _keep(self._within.setdefault(_network(address.ip, shorter), []), member)

    def first_overlap(self, interface: Interface, ip: addresses.Interface) -> Member | None:
        """The first other address of another interface whose network overlaps that of an address."""
        length = ip.network.prefixlen
        lists = [self._exact.get(_network(ip, shorter), []) for shorter in range(length)]
        lists.append(self._within.get(_network(ip, length), []))
        host = ip.ip
        members = (member for found in lists for member in found if member.conflicts(interface, host))
        return min(members, key=lambda member: member.order, default=None)


def _network(ip: addresses.Interface, length: int) -> Network:
    return ip.version, length, int(ip) >> (ip.max_prefixlen - length)


def _keep(members: list[Member], new: Member) -> None:
    """Keep a member unless those before it answer every question that it answers, so that a list stays short: a
    question rules out one interface and one address, two members of each at most, and so leaves one of five."""
    if len(members) >= 5:
        return
    of_interface = [member for member in members if member.interface is new.interface]
    of_address = [member for member in members if member.host == new.host]
    known = any(member.host == new.host for member in of_interface)
    if not known and len(of_interface) < 2 and len(of_address) < 2:
        members.append(new)
