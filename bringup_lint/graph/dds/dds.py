"""DDS configuration of a robot: the files, as the versions of its ROS distribution read them."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from functools import cached_property
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.facts.ros import distros
from bringup_lint.facts.ros.distros import at_least
from bringup_lint.graph.commands.environment import stays_local
from bringup_lint.graph.dds import cyclonedds_discovery
from bringup_lint.graph.dds import cyclonedds_names
from bringup_lint.graph.dds import fastdds_names
from bringup_lint.graph.dds import machines
from bringup_lint.graph.dds import network as dds_network
from bringup_lint.graph.dds.selection import Selection
from bringup_lint.graph.dds.selection import largest_coexisting_group
from bringup_lint.graph.dds.selection import profile_selections
from bringup_lint.graph.dds.selection import selections
from bringup_lint.graph.dds.selection import sharing_memory
from bringup_lint.graph.dds.selection import user_of
from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.fastdds import Profiles
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.parsers import cyclonedds
from bringup_lint.parsers import fastdds
from bringup_lint.parsers.cyclonedds_values import words
from bringup_lint.source import Located
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosProcess
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
    fastdds: Library = field(default_factory=lambda: fastdds_of(None))
    profile_files: list[Profiles] = field(default_factory=list)
    """Fast DDS profile files; templates are left out."""

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
    domain_number = staticmethod(cyclonedds_discovery.domain_number)
    least_buffers = staticmethod(cyclonedds_discovery.least_buffers)
    size_of = staticmethod(cyclonedds_discovery.size_of)

    named_interfaces = staticmethod(dds_network.named_interfaces)
    device = staticmethod(dds_network.device)
    may_exist = staticmethod(dds_network.may_exist)
    networks = staticmethod(dds_network.networks)
    subnets = staticmethod(dds_network.subnets)
    interface_with = staticmethod(dds_network.interface_with)
    routed = staticmethod(dds_network.routed)

    fastdds_spelling = staticmethod(fastdds_names.spelling)
    fastdds_versions = staticmethod(fastdds_names.versions)
    fastdds_places = staticmethod(fastdds_names.places)
    fastdds_words = staticmethod(fastdds_names.allowed)
    first_named = staticmethod(fastdds_names.first_named)
    transport_named = staticmethod(fastdds_names.transport_named)
    with_blanks = staticmethod(fastdds_names.with_blanks)
    multicast_peers = staticmethod(fastdds_names.multicast_peers)
    initial_peers = staticmethod(fastdds_names.initial_peers)
    listed_addresses = staticmethod(fastdds_names.listed_addresses)
    seconds = staticmethod(fastdds_names.seconds)
    overwritten_qos = staticmethod(fastdds_names.overwritten_qos)
    transport_type = staticmethod(fastdds_names.transport_type)
    number = staticmethod(fastdds_names.number)
    used_transports = staticmethod(fastdds_names.used_transports)

    def fastdds_remarks(self, *codes: Code) -> Iterator[tuple[Profiles, Remark]]:
        """What the library would say about the Fast DDS files, by code."""
        for profiles in self.profile_files:
            for remark in profiles.remarks:
                if remark.code in codes:
                    yield profiles, remark

    def locator_ports(self) -> Iterator[Located]:
        """Every port of a UDP locator in the Fast DDS files."""
        for profiles in self.profile_files:
            yield from fastdds_names.locator_ports(profiles)

    def own_places(self, configuration: Configuration | Profiles) -> list[Located]:
        """Where the robot's static addresses are written."""
        plan = self.plan_of(configuration)
        return [each.text for one in plan.interfaces.values() for each in one.addresses] if plan else []

    def plan_of(self, configuration: Configuration | Profiles) -> Plan | None:
        """The netplan of the same robot, when the tree holds exactly one and the file is no unused variant."""
        return dds_network.plan_of(self.robot, configuration.source) if self.in_use(configuration) else None

    def in_use(self, configuration: Configuration | Profiles) -> bool:
        """Whether a process of the tree reads a file, or no process is known to read any of its sort."""
        if isinstance(configuration, Profiles):
            return bool(self.profile_readers(configuration)) or not self._profile_selections
        return bool(self.readers(configuration)) or not any(each.files for each in self.selections)

    def waits_for(self, configuration: Configuration | Profiles, interface: str) -> bool:
        """Whether units wait for an interface themselves: for its device, with the waiter, or in a script."""
        if isinstance(configuration, Profiles):
            units = [process.unit for process, _ in self.profile_readers(configuration) if process.unit]
        else:
            units = [each.unit for each in self.readers(configuration) if each.unit]
        return dds_network.waits_for(self.robot, units, interface)

    def own_addresses(self, configuration: Configuration | Profiles) -> set[str]:
        """The robot's static addresses by that netplan; empty when nobody knows."""
        plan = self.plan_of(configuration)
        if plan is None:
            return set()
        managed = {str(address.ip.ip) for _, address in self.robot.networkmanager.addresses}
        return dds_network.own_addresses(plan) | managed

    @cached_property
    def selections(self) -> list[Selection]:
        """The processes of the robot that surely read a Cyclone DDS configuration."""
        return list(selections(self.robot.files, self.robot.ros))

    user_of = staticmethod(user_of)

    @cached_property
    def sharing_memory(self) -> list[RosProcess]:
        """The unit processes that surely talk over Fast DDS shared memory."""
        return list(sharing_memory(self.robot.ros))

    def domains_of(self, process: RosProcess) -> Iterator[Domain]:
        """The Domain blocks of the Cyclone DDS files that a process reads."""
        uri = process.environment.get("CYCLONEDDS_URI")
        spans = {uri.value.span} if uri is not None else set()
        read = {id(source) for each in self.selections if each.uri.span in spans for source in each.files}
        yield from (domain for configuration, domain in self.domains if id(configuration.source) in read)

    hosts_in = staticmethod(machines.in_list)

    def other_machines(self, process: RosProcess) -> Iterator[Located]:
        """The addresses of other machines in the DDS files that a process reads."""
        return machines.other_machines(self.robot, process)

    def machines_of(self, process: RosProcess) -> Iterator[Located]:
        """The same, those of ROS_STATIC_PEERS first where the distribution reads it."""
        value = process.environment.get(machines.STATIC_PEERS)
        if value is not None and value.text == value.value and at_least(self.distro, "iron"):
            yield from (host for host in machines.in_list(value.value) if machines.is_elsewhere(host))
        yield from self.other_machines(process)

    def keeps_to_itself(self, process: RosProcess) -> bool:
        """Whether a process surely does no discovery by multicast, or may be told so by a file that is not known."""
        environment = process.environment
        if stays_local(environment) or machines.SERVER in environment:
            return True
        off = (cyclonedds_discovery.multicast_off(domain) for domain in self.domains_of(process))
        return any(off) or any(self.profile_readers(each) for each in self.profile_files)

    @cached_property
    def _profile_selections(self) -> list[tuple[RosProcess, Located, Source]]:
        return list(profile_selections(self.robot.files, self.robot.ros, self.fastdds.version))

    def profile_readers(self, profiles: Profiles) -> list[tuple[RosProcess, Located]]:
        """The processes that read a profiles file, each with the value that names it."""
        found = self._profile_selections
        return [(process, value) for process, value, source in found if source is profiles.source]

    def largest_coexisting_group(self, configuration: Configuration) -> list[Selection]:
        """The readers of a file that surely run at the same time."""
        return largest_coexisting_group(self.robot.units, self.readers(configuration))

    def readers(self, configuration: Configuration) -> list[Selection]:
        """The processes that read a configuration file."""
        return [each for each in self.selections if configuration.source in each.files]

    def remarks(self, *codes: Code) -> Iterator[tuple[Configuration, Remark]]:
        """What the library would say about the Cyclone DDS files, by code."""
        for configuration in self.configurations:
            for remark in configuration.all_remarks:
                if remark.code in codes:
                    yield configuration, remark

    @property
    def domains(self) -> Iterator[tuple[Configuration, Domain]]:
        """Every Domain block of the Cyclone DDS files whose XML can be read to the end."""
        for configuration in self.configurations:
            if not any(remark.fatal and remark.code in (Code.XML, Code.ROOT) for remark in configuration.remarks):
                for domain in configuration.domains:
                    yield configuration, domain

    @property
    def old_discovery(self) -> bool:
        """Whether only the file decides on discovery: no ROS_STATIC_PEERS, no discovery range, no index set
        by the RMW."""
        return self.distro in BEFORE_DISCOVERY_OPTIONS


def load_dds(robot: Robot) -> Dds:
    distro = robot.target.ros
    cyclone, fast = cyclonedds_of(distro), fastdds_of(distro)
    files = [source for source in robot.of_kind("cyclonedds", "fastdds") if not source.template]
    read = partial(cyclonedds.parse, version=cyclone.version)
    profiles = robot.parsed(
        partial(fastdds.parse, version=SERIES.get(fast.version, fast.version)),
        [source for source in files if source.kind == "fastdds"],
    )
    dds = Dds(robot, cyclone, distro, fastdds=fast, profile_files=profiles)
    dds.configurations = robot.parsed(read, [source for source in files if source.kind == "cyclonedds"])
    if any(INLINE in source.text for source in robot.sources):
        dds.configurations += _inline(dds, read)
    return dds


INLINE = "CYCLONEDDS_URI"


def _inline(dds: Dds, read: Callable[..., Configuration]) -> Iterator[Configuration]:
    """The configurations that stand in environments themselves, each place once."""
    regions = {}
    for selection in dds.selections:
        for text in selection.inline:
            if text.span.text == text:
                regions[(id(text.span.source), text.span.start)] = text.span
    for span in regions.values():
        yield read(span.source, inline=True, region=(span.start, span.end))


SERIES = {"2.1": "2.6", "2.3": "2.6", "2.10": "2.14"}
"""The series whose table stands in for one that has none."""


def cyclonedds_of(distro: str | None) -> Library:
    return _library("Cyclone DDS", "cyclonedds", distro, cyclonedds.DEFAULT_VERSION)


def fastdds_of(distro: str | None) -> Library:
    return _library("Fast DDS", "fastdds", distro, fastdds.DEFAULT_VERSION)


def _library(name: str, column: str, distro: str | None, default: str) -> Library:
    known = distros.every().get(distro or "")
    version = getattr(known, column) if known else ""
    if version:
        return Library(name, version, True, f"ROS {distro}")
    return Library(name, default, False, "no ROS distribution is known")
