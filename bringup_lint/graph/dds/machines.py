"""The other machines that a process is told to talk to: peers and discovery servers, in variables and in files."""

from __future__ import annotations

import ipaddress
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.dds.cyclonedds_discovery import address_of
from bringup_lint.graph.dds.cyclonedds_discovery import peers
from bringup_lint.model.fastdds import Profiles
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.robot import Robot

STATIC_PEERS, SERVER = "ROS_STATIC_PEERS", "ROS_DISCOVERY_SERVER"
_LISTS = ("initialPeersList", "discoveryServersList")
_SERVER = re.compile(r"\[?(?P<host>[0-9a-fA-F:]*:[0-9a-fA-F:]*|[^:\[\];]+)\]?(?::\d+)?")


def other_machines(robot: Robot, process: RosProcess) -> Iterator[Located]:
    """The addresses of other machines in the DDS files that a process reads."""
    own = {address for plan in robot.netplan.plans for address in _own(plan)} if robot.of_kind("netplan") else set()
    for place in (*_of_cyclonedds(robot, process), *_of_fastdds(robot, process)):
        address = address_of(place)
        if address is not None and is_elsewhere(str(address)) and str(address) not in own:
            yield place


def is_elsewhere(host: str) -> bool:
    """Whether a text is the address of one other machine."""
    try:
        address = ipaddress.ip_address(host)
    except ValueError:
        return False
    return not (address.is_loopback or address.is_multicast or address.is_unspecified)


def in_list(value: Located) -> Iterator[Located]:
    """The hosts of ROS_STATIC_PEERS or ROS_DISCOVERY_SERVER, separated by semicolons, without their ports."""
    at = 0
    for part in value.split(";"):
        found = _SERVER.fullmatch(part.strip())
        if found is not None:
            start = at + part.index(part.strip()) + found.start("host")
            yield value.part(start, start + len(found["host"]))
        at += len(part) + 1


def _own(plan) -> Iterator[str]:
    for interface in plan.interfaces.values():
        yield from (str(each.ip.ip) for each in interface.addresses if each.ip is not None)


def _of_cyclonedds(robot: Robot, process: RosProcess) -> Iterator[Located]:
    for domain in robot.dds.domains_of(process):
        yield from peers(domain)


def _of_fastdds(robot: Robot, process: RosProcess) -> Iterator[Located]:
    for profiles in robot.dds.profile_files:
        if not profiles.dropped and any(each is process for each, _ in robot.dds.profile_readers(profiles)):
            yield from listed_addresses(profiles)


def listed_addresses(profiles: Profiles) -> Iterator[Located]:
    """The addresses of initial peers and discovery servers of the default participant."""
    for profile in profiles.of_kind("participant"):
        for element in profile.element.walk() if profile.is_default else ():
            if element.local in _LISTS:
                yield from (each.text for each in element.walk() if each.local == "address")
