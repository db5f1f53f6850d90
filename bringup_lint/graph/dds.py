"""DDS configuration of a robot: the files, as the versions of its ROS distribution read them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.facts import table
from bringup_lint.graph import cyclonedds_discovery
from bringup_lint.graph import cyclonedds_names
from bringup_lint.graph import dds_network
from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.cyclonedds import Remark
from bringup_lint.parsers.cyclonedds import DEFAULT_VERSION
from bringup_lint.parsers.cyclonedds import parse as parse_cyclonedds
from bringup_lint.parsers.cyclonedds_values import words

if TYPE_CHECKING:
    from bringup_lint.model.netplan import Plan
    from bringup_lint.robot import Robot

BEFORE_DISCOVERY_OPTIONS = ("foxy", "galactic", "humble")
"""Distributions whose rmw_cyclonedds adds nothing of its own before the user's configuration."""


@dataclass(frozen=True)
class Library:
    """A DDS library in the version that the robot runs."""

    name: str
    version: str
    known: bool
    """Whether the tree tells the ROS distribution; else the version is assumed."""
    why: str

    def __str__(self) -> str:
        return f"{self.name} {self.version}" + ("" if self.known else " (assumed)")


@dataclass(eq=False)
class Dds:
    robot: Robot
    cyclonedds: Library
    distro: str | None
    configurations: list[Configuration] = field(default_factory=list)
    """Cyclone DDS files; templates, whose text is not final, are left out."""

    accepted_by = staticmethod(cyclonedds_names.accepted_by)
    spelling = staticmethod(cyclonedds_names.spelling)
    place = staticmethod(cyclonedds_names.place)
    renamed = staticmethod(cyclonedds_names.renamed)
    first_of = staticmethod(cyclonedds_names.first_of)
    interfaces_instead = staticmethod(cyclonedds_names.interfaces_instead)
    taken_by = staticmethod(cyclonedds_names.taken_by)
    words_of = staticmethod(words)
    multicast_off = staticmethod(cyclonedds_discovery.multicast_off)
    on_loopback_only = staticmethod(cyclonedds_discovery.on_loopback_only)
    has_peers = staticmethod(cyclonedds_discovery.has_peers)
    peers = staticmethod(cyclonedds_discovery.peers)
    peer_addresses = staticmethod(cyclonedds_discovery.peer_addresses)
    contacts_itself = staticmethod(cyclonedds_discovery.contacts_itself)
    bad_addresses = staticmethod(cyclonedds_discovery.bad_addresses)
    is_address = staticmethod(cyclonedds_discovery.is_address)
    address_of = staticmethod(cyclonedds_discovery.address_of)
    least_buffers = staticmethod(cyclonedds_discovery.least_buffers)
    size_of = staticmethod(cyclonedds_discovery.size_of)

    named_interfaces = staticmethod(dds_network.named_interfaces)
    device = staticmethod(dds_network.device)
    may_exist = staticmethod(dds_network.may_exist)
    networks = staticmethod(dds_network.networks)
    routed = staticmethod(dds_network.routed)

    def plan_of(self, configuration: Configuration) -> Plan | None:
        """The netplan of the same robot, when the tree holds exactly one."""
        return dds_network.plan_of(self.robot, configuration.source)

    def own_addresses(self, configuration: Configuration) -> set[str]:
        """The robot's static addresses by that netplan; empty when nobody knows."""
        plan = self.plan_of(configuration)
        return dds_network.own_addresses(plan) if plan else set()

    def remarks(self, *codes: str) -> Iterator[tuple[Configuration, Remark]]:
        """What the library would say about the Cyclone DDS files, by code."""
        for configuration in self.configurations:
            for remark in configuration.all_remarks:
                if remark.code in codes:
                    yield configuration, remark

    @property
    def domains(self) -> Iterator[tuple[Configuration, Domain]]:
        """Every Domain block of the Cyclone DDS files whose XML can be read to the end."""
        for configuration in self.configurations:
            if not any(remark.fatal and remark.code in ("xml", "root") for remark in configuration.remarks):
                for domain in configuration.domains:
                    yield configuration, domain

    @property
    def old_discovery(self) -> bool:
        """Whether only the file decides on discovery: no ROS_STATIC_PEERS, no discovery range, no index set by the RMW."""
        return self.distro in BEFORE_DISCOVERY_OPTIONS


def load_dds(robot: Robot) -> Dds:
    library = cyclonedds_of(robot.target.ros)
    sources = [source for source in robot.of_kind("cyclonedds") if not source.template]
    parse = partial(parse_cyclonedds, version=library.version)
    return Dds(robot, library, robot.target.ros, robot.parsed(parse, sources))


def cyclonedds_of(distro: str | None) -> Library:
    for row in table("dds_versions"):
        if row["distro"] == distro:
            return Library("Cyclone DDS", row["cyclonedds"], True, f"ROS {distro}")
    return Library("Cyclone DDS", DEFAULT_VERSION, False, "Humble to Kilted have it")
