"""Robot: all that is known about one robot. This is what rules ask."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import field
from datetime import date
from functools import cached_property
from typing import TYPE_CHECKING
from typing import TypeVar

from bringup_lint.graph.target import Target
from bringup_lint.graph.target import find_target
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source

if TYPE_CHECKING:
    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.compose import Compose
    from bringup_lint.graph.dds.dds import Dds
    from bringup_lint.graph.environment.env_files import UsedEnvFile
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.graph import Graph
    from bringup_lint.graph.host.accounts import Accounts
    from bringup_lint.graph.host.can import Can
    from bringup_lint.graph.host.device_access import ClosedDevice
    from bringup_lint.graph.host.devices import Devices
    from bringup_lint.graph.host.files import Jail
    from bringup_lint.graph.host.fstab import NeededPath
    from bringup_lint.graph.host.logs import RosLogs
    from bringup_lint.graph.host.sshd import Sshd
    from bringup_lint.graph.host.sysctl import Sysctl
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.observed.expected import Expected
    from bringup_lint.graph.observed.observed import LivingRobot
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.provenance import Ways
    from bringup_lint.graph.secrets.in_clear import Secret
    from bringup_lint.graph.secrets.ros import Indirect
    from bringup_lint.graph.sros2.sros2 import Sros2
    from bringup_lint.graph.supervision.notify import Notify
    from bringup_lint.graph.supervision.watchdog import Watchdog
    from bringup_lint.graph.systemd.daemons import Daemon
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.graph.udev.udev import Udev
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.env_file import EnvFile
    from bringup_lint.model.firewall import Firewall
    from bringup_lint.model.fstab import Fstab
    from bringup_lint.model.netplan import Netplan
    from bringup_lint.model.shell import Command

Model = TypeVar("Model")

_CONFIGURES_MIDDLEWARE = re.compile(
    r"""CYCLONEDDS_URI["']?\s*[:=][^\n]*<|RMW_IMPLEMENTATION["']?\s*[:=]\s*["']?rmw_fastrtps_"""
)
_ROS_KINDS = (
    "launch-python",
    "launch-xml",
    "launch-yaml",
    "python-node",
    "ros-param",
    "params",
    "cyclonedds",
    "fastdds",
    "sros2",
)


@dataclass(eq=False)
class Robot:
    """The sources of one run and everything derived from them, each layer on first use."""

    tree: Tree
    configured_ros: str | None = None
    configured_systemd: int | None = None
    today: date = field(default_factory=date.today)
    """The day for which validity dates are judged."""
    launch_commands: tuple[str, ...] = ()
    """For a comparison with the running graph: what was launched, as behind ``ros2 launch``."""
    failures: list[tuple[Source, Exception]] = field(default_factory=list)
    """Sources on which a parser failed inside."""

    @property
    def sources(self) -> list[Source]:
        return self.tree.sources

    @cached_property
    def _by_kind(self) -> dict[str, list[Source]]:
        by_kind: dict[str, list[Source]] = {}
        for source in self.sources:
            by_kind.setdefault(source.kind, []).append(source)
        return by_kind

    def join(self, source: Source) -> None:
        """Take in a source that comes later, of a kind that nothing asked for before."""
        self._by_kind.setdefault(source.kind, []).append(source)
        self.sources.append(source)

    def of_kind(self, *kinds: str) -> list[Source]:
        return [source for kind in kinds for source in self._by_kind.get(kind, ())]

    def parsed(self, parse: Callable[[Source], Model], sources: Iterable[Source]) -> list[Model]:
        """The models of the sources. A parser that fails costs its own source: it is noted in ``failures``."""
        models = []
        for source in sources:
            try:
                models.append(parse(source))
            except Exception as error:
                self.failures.append((source, error))
        return models

    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of file in the tree."""
        return frozenset(self._by_kind)

    def mentions(self, pattern: re.Pattern[str]) -> bool:
        """Whether the text of a judged file matches."""
        return any(pattern.search(source.text) for source in self.sources if source.judged)

    @property
    def problems(self) -> list[Problem]:
        """What could not be read at all: unreadable, oversized or binary files."""
        return self.tree.problems

    @cached_property
    def target(self) -> Target:
        return find_target(self.sources, self.configured_ros, self.configured_systemd)

    @cached_property
    def is_ros(self) -> bool:
        """Whether the tree has to do with ROS 2: something of it names a distribution, configures a middleware in the
        environment, or is a kind that only ROS has."""
        return (
            self.target.ros_why != "not known"
            or any(kind.startswith(_ROS_KINDS) for kind in self.kinds)
            or self.mentions(_CONFIGURES_MIDDLEWARE)
        )

    def environment_file(self, robot_path: str) -> EnvFile | None:
        """The environment file at a path on the robot, when the tree holds it."""
        from bringup_lint.parsers.env_file import parse

        source = self.tree.find(robot_path)
        return next(iter(self.parsed(parse, [source])), None) if source else None

    @cached_property
    def secrets(self) -> list[Secret]:
        """Secrets that stand in clear text in units, environment files, compose files and Dockerfiles."""
        from bringup_lint.graph.secrets.in_clear import secrets

        return list(secrets(self))

    @cached_property
    def exposed_secrets(self) -> list[Indirect]:
        """Parameters that hand a secret to a node."""
        from bringup_lint.graph.secrets.in_clear import exposed

        return list(exposed(self))

    @cached_property
    def units(self) -> Units:
        from bringup_lint.graph.systemd.unit_loading import load_units

        return load_units(self)

    @cached_property
    def env_files(self) -> list[UsedEnvFile]:
        from bringup_lint.graph.environment.env_files import used_env_files

        return used_env_files(self)

    @cached_property
    def netplan(self) -> Netplan:
        from bringup_lint.graph.netplan.netplan import load_netplan

        return load_netplan(self)

    @cached_property
    def sysctl(self) -> Sysctl:
        from bringup_lint.graph.host.sysctl import load_sysctl

        return load_sysctl(self)

    @cached_property
    def dds(self) -> Dds:
        from bringup_lint.graph.dds.dds import load_dds

        return load_dds(self)

    @cached_property
    def udev(self) -> Udev:
        from bringup_lint.graph.udev.udev import load_udev

        return load_udev(self)

    @cached_property
    def devices(self) -> Devices:
        from bringup_lint.graph.host.devices import load_devices

        return load_devices(self)

    @cached_property
    def closed_devices(self) -> list[ClosedDevice]:
        """The devices that services name and that their users may not open."""
        from bringup_lint.graph.host.device_access import closed_devices

        return list(closed_devices(self)) if self.tree.complete and self.of_kind("udev-rules") else []

    @cached_property
    def waiting_for_network(self) -> list[tuple[str, Located]]:
        """Units that are ordered after network-online.target, with the word that says so."""
        from bringup_lint.graph.systemd.network_online import waiting_for_network

        plan = self.netplan.only_plan
        found = waiting_for_network(self.units)
        return [each for each in found if plan is None or self.together(each[1], plan.files[0].source)]

    @cached_property
    def notify(self) -> Notify:
        from bringup_lint.graph.supervision.notify import Notify

        return Notify(self)

    @cached_property
    def launch(self) -> Launch:
        from bringup_lint.graph.launch.launch import load_launch

        return load_launch(self)

    @cached_property
    def nodes(self) -> Nodes:
        """The Python sources of nodes, and which of them a launch file starts."""
        from bringup_lint.graph.nodes.nodes import load_nodes

        return load_nodes(self)

    @cached_property
    def params(self) -> Params:
        from bringup_lint.graph.params.params import load_params

        return load_params(self)

    @cached_property
    def topics(self) -> Topics:
        """What launched nodes publish and subscribe, under full names."""
        from bringup_lint.graph.topics.topics import load_topics

        return load_topics(self)

    @cached_property
    def accounts(self) -> Accounts:
        from bringup_lint.graph.host.accounts import load_accounts

        return load_accounts(self)

    @cached_property
    def journald(self) -> list[Daemon]:
        from bringup_lint.graph.systemd.daemons import load_daemons

        return load_daemons(self, "journald")

    @cached_property
    def system_conf(self) -> list[Daemon]:
        from bringup_lint.graph.systemd.daemons import load_daemons

        return load_daemons(self, "system")

    @cached_property
    def logind(self) -> list[Daemon]:
        from bringup_lint.graph.systemd.daemons import load_daemons

        return load_daemons(self, "logind")

    @cached_property
    def sshd(self) -> list[Sshd]:
        from bringup_lint.graph.host.sshd import load_sshd

        return load_sshd(self)

    @cached_property
    def watchdog(self) -> Watchdog:
        from bringup_lint.graph.supervision.watchdog import Watchdog

        return Watchdog(self)

    @cached_property
    def logs(self) -> RosLogs:
        """What units and ROS write, and the logrotate files that rotate it."""
        from bringup_lint.graph.host.logs import RosLogs

        return RosLogs(self)

    @cached_property
    def compose(self) -> Compose:
        from bringup_lint.graph.compose import load_compose

        return load_compose(self)

    @cached_property
    def dockerfiles(self) -> list[Dockerfile]:
        from bringup_lint.parsers.dockerfile import parse

        return self.parsed(parse, [source for source in self.of_kind("dockerfile") if not source.template])

    @cached_property
    def firewalls(self) -> list[Firewall]:
        from bringup_lint.graph.host.firewall import load_firewalls

        return load_firewalls(self)

    @cached_property
    def ssh_forwards(self) -> list[tuple[Source, int, Located]]:
        """The ports that scripts forward over SSH, with the word that says so."""
        from bringup_lint.graph.host.firewall import ssh_forwards

        return list(ssh_forwards(self))

    @cached_property
    def dds_domain(self) -> tuple[int, Located] | None:
        """The DDS domain that the tree sets, when all its files agree on one."""
        from bringup_lint.graph.host.firewall import dds_domain

        return dds_domain(self)

    @cached_property
    def fstabs(self) -> list[Fstab]:
        from bringup_lint.parsers.fstab import parse

        return self.parsed(parse, [source for source in self.of_kind("fstab") if not source.template])

    @staticmethod
    def mount_options(filesystem: str) -> list[str]:
        """The mount options of a file system; empty when they are not known."""
        from bringup_lint.graph.host.fstab import mount_options

        return mount_options(filesystem)

    @property
    def lost_directories(self) -> list[NeededPath]:
        """Directories that units need on a tmpfs and that nothing makes at boot."""
        from bringup_lint.graph.host.fstab import lost_directories

        return list(lost_directories(self))

    @property
    def read_only_writes(self) -> list[NeededPath]:
        """Paths that units write to on a read-only root."""
        from bringup_lint.graph.host.fstab import read_only_writes

        return list(read_only_writes(self))

    @cached_property
    def jails(self) -> list[Jail]:
        from bringup_lint.graph.host.files import parse_jail

        return self.parsed(parse_jail, self.of_kind("fail2ban-jail"))

    @cached_property
    def sshd_sources(self) -> list[Source]:
        from bringup_lint.graph.host.files import sshd_sources

        return sshd_sources(self)

    @cached_property
    def installations(self) -> list[tuple[Source, Command]]:
        """The commands of scripts and Dockerfiles that install packages with apt."""
        from bringup_lint.graph.host.files import installations

        return list(installations(self))

    @cached_property
    def can(self) -> Can:
        from bringup_lint.graph.host.can import Can

        return Can(self)

    @cached_property
    def graph(self) -> Graph:
        """Everything that the files of the tree name, and how it depends on each other: from units to topics."""
        from bringup_lint.graph.edges.joined import joined_graph

        return joined_graph(self)

    @cached_property
    def ros(self) -> RosEnvironment:
        """The variables of ROS 2, wherever they are set, and the environment of every process that runs it."""
        from bringup_lint.graph.environment.ros import RosEnvironment

        return RosEnvironment(self)

    @cached_property
    def sros2(self) -> Sros2:
        """Keystores, enclaves, governance and permissions documents, and the processes that use them."""
        from bringup_lint.graph.sros2.sros2 import load_sros2

        return load_sros2(self)

    @cached_property
    def ways(self) -> Ways:
        """How things come into effect: the chain of lines from a unit to a place."""
        from bringup_lint.graph.provenance import Ways

        return Ways(self)

    @cached_property
    def expected(self) -> Expected:
        """The nodes that the files start, for a comparison with the running graph."""
        from bringup_lint.graph.observed.expected import expected

        return expected(self)

    @cached_property
    def living(self) -> LivingRobot | None:
        """The running graph held against the files; None in a run that looks at files only."""
        from bringup_lint.graph.observed.observed import load_living

        return load_living(self)

    @cached_property
    def kinds_below(self) -> dict[str, set[str]]:
        """The kinds of files below every folder that tell robots and variants apart."""
        from bringup_lint.graph.variants import kinds_below

        return kinds_below(self)

    def together(self, one: Source | Located, other: Source | Located) -> bool:
        """Whether two files may be joined though neither names the other: they are for the same robot."""
        from bringup_lint.graph.variants import together

        sources = (each.span.source if isinstance(each, Located) else each for each in (one, other))
        return together(self, *sources)

    def find(self, robot_path: str, asked_by: Source) -> Source | None:
        """The file at a path on the robot that another file names; none of another robot or variant."""
        from bringup_lint.graph.variants import names

        found = self.tree.find(robot_path)
        return found if found is not None and names(self, robot_path, asked_by, found) else None
