"""The other machines that a process is told to talk to: peers and discovery servers in DDS files."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.addresses import address_of
from bringup_lint.addresses import is_elsewhere
from bringup_lint.graph.dds.cyclonedds_discovery import peers
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.fastdds import Profiles
from bringup_lint.model.netplan import Plan
from bringup_lint.model.xml import Element
from bringup_lint.source import Located

STATIC_PEERS, SERVER = "ROS_STATIC_PEERS", "ROS_DISCOVERY_SERVER"
_LISTS = ("initialPeersList", "discoveryServersList")


def other_machines(domains: Iterable[Domain], files: Iterable[Profiles], own: set[str]) -> Iterator[Located]:
    """The addresses of other machines in Domain blocks and profile files; ``own`` are the robot's own ones."""
    for place in (*_peers(domains), *_listed(files)):
        address = address_of(place)
        if address is not None and is_elsewhere(str(address)) and str(address) not in own:
            yield place


def static_addresses(plans: Iterable[Plan]) -> set[str]:
    """The static addresses that netplan gives to the robot."""
    interfaces = (interface for plan in plans for interface in plan.interfaces.values())
    return {str(each.ip.ip) for interface in interfaces for each in interface.addresses if each.ip is not None}


def _peers(domains: Iterable[Domain]) -> Iterator[Located]:
    for domain in domains:
        yield from peers(domain)


def _listed(files: Iterable[Profiles]) -> Iterator[Located]:
    """The addresses of initial peers and discovery servers of the default participants."""
    for profiles in files:
        for participant in profiles.default_participants:
            yield from _addresses(participant)


def _addresses(participant: Element) -> Iterator[Located]:
    for element in participant.walk():
        if element.local in _LISTS:
            yield from (each.text for each in element.walk() if each.local == "address")
