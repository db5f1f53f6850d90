"""DDS configuration of a robot: the files, as the versions of its ROS distribution read them, and who reads them."""

from __future__ import annotations

from collections.abc import Callable
from collections.abc import Iterator
from functools import cached_property
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.addresses import hosts_in
from bringup_lint.addresses import is_elsewhere
from bringup_lint.dataclass import dataclass
from bringup_lint.facts.ros.distros import at_least
from bringup_lint.graph.commands.environment import stays_local
from bringup_lint.graph.dds import machines
from bringup_lint.graph.dds import network
from bringup_lint.graph.dds.cyclonedds_discovery import multicast_off
from bringup_lint.graph.dds.fastdds_names import locator_ports
from bringup_lint.graph.dds.library import SERIES
from bringup_lint.graph.dds.library import Library
from bringup_lint.graph.dds.library import cyclonedds_of
from bringup_lint.graph.dds.library import fastdds_of
from bringup_lint.graph.dds.named import is_chosen
from bringup_lint.graph.dds.named import is_named
from bringup_lint.graph.dds.named import named_files
from bringup_lint.graph.dds.selection import URI
from bringup_lint.graph.dds.selection import Selection
from bringup_lint.graph.dds.selection import largest_coexisting_group
from bringup_lint.graph.dds.selection import profile_selections
from bringup_lint.graph.dds.selection import selections
from bringup_lint.graph.dds.selection import sharing_memory
from bringup_lint.model.cyclonedds import Configuration
from bringup_lint.model.cyclonedds import Domain
from bringup_lint.model.fastdds import Profile
from bringup_lint.model.fastdds import Profiles
from bringup_lint.model.schema import Code
from bringup_lint.model.schema import Remark
from bringup_lint.parsers import cyclonedds
from bringup_lint.parsers import fastdds
from bringup_lint.parsers.cyclonedds_uri import split_uri
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.addresses import Address
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.networkmanager.profiles import NetworkManager
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.netplan import Netplan
    from bringup_lint.model.netplan import Plan

BEFORE_DISCOVERY_OPTIONS = ("foxy", "galactic", "humble")
"""Distributions whose rmw_cyclonedds adds nothing of its own before the user's configuration."""


@dataclass(eq=False)
class Dds:
    """The DDS files of a tree. Templates, whose text is not final, are left out."""

    files: Files
    ros: RosEnvironment
    units: Callable[[], Units]
    netplan: Callable[[], Netplan]
    networkmanager: Callable[[], NetworkManager]

    @property
    def distro(self) -> str | None:
        return self.files.target.ros

    @cached_property
    def cyclonedds(self) -> Library:
        return cyclonedds_of(self.distro)

    @cached_property
    def fastdds(self) -> Library:
        return fastdds_of(self.distro)

    def _sources(self, kind: str) -> list[Source]:
        known = [source for source in self.files.of_kind(kind) if not source.template]
        if not is_named(self.files, kind):
            return known
        if kind == "cyclonedds":
            read = [source for each in self.selections for source in each.files]
        else:
            read = [source for _, _, source in self._profile_selections]
        return known + named_files(self.files, self.ros, kind, read)

    @cached_property
    def configurations(self) -> list[Configuration]:
        """The Cyclone DDS files, and the configurations that environments hold themselves."""
        read = partial(cyclonedds.parse, version=self.cyclonedds.version)
        found = self.files.parsed(read, self._sources("cyclonedds"))
        if any(URI in source.text for source in self.files.sources):
            found += [read(span.source, inline=True, region=(span.start, span.end)) for span in self._inline()]
        return found

    def _inline(self) -> list[Span]:
        """Where environments and the scripts and login files that set them hold a configuration, each place once."""
        texts = [text for selection in self.selections for text in selection.inline]
        for setting in self.ros.of(URI):
            texts += [part.text for part in split_uri(setting.value) if part.inline]
        return list(dict.fromkeys(text.span for text in texts if text.span.text == text))

    @cached_property
    def profile_files(self) -> list[Profiles]:
        """The Fast DDS profile files."""
        version = SERIES.get(self.fastdds.version, self.fastdds.version)
        read = partial(fastdds.parse, version=version)
        return self.files.parsed(read if self.fastdds.known else fastdds.fitting, self._sources("fastdds"))

    def is_chosen_by_name(self, profile: Profile) -> bool:
        """Whether a program that is no ROS node chooses the profile by its name."""
        return profile.name is not None and is_chosen(self.files, str(profile.name))

    def remarks(self, *codes: Code) -> Iterator[tuple[Configuration, Remark]]:
        """What the library would say about the Cyclone DDS files, by code."""
        for configuration in self.configurations:
            for remark in configuration.all_remarks:
                if remark.code in codes:
                    yield configuration, remark

    def fastdds_remarks(self, *codes: Code) -> Iterator[tuple[Profiles, Remark]]:
        """What the library would say about the Fast DDS files, by code."""
        for profiles in self.profile_files:
            for remark in profiles.remarks:
                if remark.code in codes:
                    yield profiles, remark

    @property
    def domains(self) -> Iterator[tuple[Configuration, Domain]]:
        """Every Domain block of the Cyclone DDS files whose XML can be read to the end."""
        for configuration in self.configurations:
            if not any(remark.fatal and remark.code in (Code.XML, Code.ROOT) for remark in configuration.remarks):
                for domain in configuration.domains:
                    yield configuration, domain

    def locator_ports(self) -> Iterator[Located]:
        """Every port of a UDP locator in the Fast DDS files."""
        for profiles in self.profile_files:
            yield from locator_ports(profiles)

    @property
    def old_discovery(self) -> bool:
        """Whether only the file decides on discovery: no ROS_STATIC_PEERS, no discovery range, no index set
        by the RMW."""
        return self.distro in BEFORE_DISCOVERY_OPTIONS

    @cached_property
    def selections(self) -> list[Selection]:
        """The processes of the robot that surely read a Cyclone DDS configuration."""
        return list(selections(self.files, self.ros))

    @cached_property
    def _profile_selections(self) -> list[tuple[RosProcess, Located, Source]]:
        return list(profile_selections(self.files, self.ros, self.fastdds.version))

    def readers(self, configuration: Configuration) -> list[Selection]:
        """The processes that read a configuration file."""
        return self._readers.get(configuration.source, [])

    def is_part(self, configuration: Configuration) -> bool:
        """Whether a process reads the file or text together with others, which may say what is missing here."""
        lists = [each for each in self.selections if len(each.files) + len(each.inline) > 1 or not each.complete]
        parts = {part for each in lists for part in (*each.files, *(text.span.source for text in each.inline))}
        return configuration.source in parts

    @cached_property
    def _readers(self) -> dict[Source, list[Selection]]:
        found: dict[Source, list[Selection]] = {}
        for each in self.selections:
            for source in dict.fromkeys(each.files):
                found.setdefault(source, []).append(each)
        return found

    def profile_readers(self, profiles: Profiles) -> list[tuple[RosProcess, Located]]:
        """The processes that read a profiles file, each with the value that names it."""
        return self._profile_readers.get(profiles.source, [])

    @cached_property
    def _profile_readers(self) -> dict[Source, list[tuple[RosProcess, Located]]]:
        found: dict[Source, list[tuple[RosProcess, Located]]] = {}
        for process, value, source in self._profile_selections:
            found.setdefault(source, []).append((process, value))
        return found

    def _runners(self, configuration: Configuration | Profiles) -> Iterator[Runner]:
        """Who starts the processes that read a file."""
        if isinstance(configuration, Profiles):
            readers = [process for process, _ in self.profile_readers(configuration)]
        else:
            readers = [each.process for each in self.readers(configuration)]
        return (each.runner for each in readers if each.runner is not None)

    def in_use(self, configuration: Configuration | Profiles) -> bool:
        """Whether a process of the tree reads a file, or no process is known to read any of its sort."""
        if isinstance(configuration, Profiles):
            return bool(self.profile_readers(configuration)) or not self._profile_selections
        return bool(self.readers(configuration)) or not self._readers

    def domains_of(self, process: RosProcess) -> Iterator[Domain]:
        """The Domain blocks of the Cyclone DDS files that a process reads."""
        uri = process.environment.get(URI)
        if uri is None:
            return
        read = {file for each in self.selections if each.uri.span == uri.value.span for file in each.files}
        yield from (domain for configuration, domain in self.domains if configuration.source in read)

    def profiles_of(self, process: RosProcess) -> list[Profiles]:
        """The Fast DDS files that a process reads."""
        read = {source for each, _, source in self._profile_selections if each is process}
        return [profiles for profiles in self.profile_files if profiles.source in read]

    def largest_coexisting_group(self, configuration: Configuration) -> list[Selection]:
        """The readers of a file that surely run at the same time."""
        return largest_coexisting_group(self.units(), self.readers(configuration))

    @cached_property
    def sharing_memory(self) -> list[RosProcess]:
        """The unit processes that surely talk over Fast DDS shared memory."""
        return list(sharing_memory(self.ros))

    def plan_of(self, configuration: Configuration | Profiles) -> Plan | None:
        """The netplan of the same robot, when the tree holds exactly one and the file is no unused variant."""
        return network.plan_of(self.netplan(), configuration.source) if self.in_use(configuration) else None

    def may_reach(self, plan: Plan, address: Address) -> bool:
        """Whether a subnet, a route or a VPN of the robot may lead to an address."""
        return network.is_routed(plan, address) or self._makes_tunnels

    @cached_property
    def _makes_tunnels(self) -> bool:
        return network.makes_tunnels(self.files)

    def own_places(self, configuration: Configuration | Profiles) -> list[Located]:
        """Where the robot's static addresses are written."""
        plan = self.plan_of(configuration)
        return [each.text for one in plan.interfaces.values() for each in one.addresses] if plan else []

    def own_addresses(self, configuration: Configuration | Profiles) -> set[str]:
        """The robot's static addresses by that netplan and NetworkManager; empty when they are not known."""
        plan = self.plan_of(configuration)
        own = network.own_addresses(plan) if plan is not None else set()
        if not own:
            return set()
        return own | {str(address.ip.ip) for _, address in self.networkmanager().addresses}

    def waits_for(self, configuration: Configuration | Profiles, interface: str) -> bool:
        """Whether those who read a file wait for an interface: for its device, with the waiter, or in a script."""
        return network.waits_for(self.units(), self._runners(configuration), interface)

    def other_machines(self, process: RosProcess) -> Iterator[Located]:
        """The addresses of other machines in the DDS files that a process reads."""
        plans = self.netplan().plans if self.files.of_kind("netplan") else []
        own = machines.static_addresses(plans)
        return machines.other_machines(self.domains_of(process), self.profiles_of(process), own)

    def machines_of(self, process: RosProcess) -> Iterator[Located]:
        """The same, those of ROS_STATIC_PEERS first where the distribution reads it."""
        value = process.environment.get(machines.STATIC_PEERS)
        if value is not None and value.text == value.value and at_least(self.distro, "iron"):
            yield from (host for host in hosts_in(value.value) if is_elsewhere(host))
        yield from self.other_machines(process)

    def keeps_to_itself(self, process: RosProcess) -> bool:
        """Whether a process surely does no discovery by multicast, or may be told so by a file that is not known."""
        environment = process.environment
        if stays_local(environment) or machines.SERVER in environment:
            return True
        off = (multicast_off(domain) for domain in self.domains_of(process))
        return any(off) or any(self.profile_readers(each) for each in self.profile_files)
