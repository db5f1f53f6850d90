"""Robot: all that is known about one robot. This is what rules ask.

It is the only module that knows all layers. A layer takes what it needs as arguments: ``Files``, and the layers below
it that it asks; none takes a ``Robot``. To construct a layer costs nothing, because all that it holds is computed on
first use (``cached_property``), so layers are passed as they are. Where one is asked in rare cases only, and its
modules would be imported in vain in most runs, a function is passed that gives it, with the parameter
``launch: Callable[[], Launch]``::

    @cached_property
    def params(self) -> Params:
        from bringup_lint.graph.params.params import Params

        return Params(self.files, lambda: self.launch)

A member is a layer, or a list that decides whether a rule is loaded at all (``rule_index``). What else a rule asks is a
function in a module of ``api``, which takes the layer.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Collection
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping
from contextlib import suppress
from functools import cached_property

from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.finding import span_of
from bringup_lint.graph.files import Files
from bringup_lint.graph.purpose import Purpose
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Any
from bringup_lint.type_names import TypeVar

if TYPE_CHECKING:
    from datetime import date

    from bringup_lint.discover.tree import Tree
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.dds.dds import Dds
    from bringup_lint.graph.dependencies.dependencies import Dependencies
    from bringup_lint.graph.edges.topics import Joins
    from bringup_lint.graph.environment.env_files import UsedEnvFile
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.graph import Graph
    from bringup_lint.graph.host.accounts import Accounts
    from bringup_lint.graph.host.can import Can
    from bringup_lint.graph.host.device_access import ClosedDevice
    from bringup_lint.graph.host.devices import Devices
    from bringup_lint.graph.host.fail2ban import Jail
    from bringup_lint.graph.host.fstab import Mounts
    from bringup_lint.graph.host.logs import RosLogs
    from bringup_lint.graph.host.open_services import OpenService
    from bringup_lint.graph.host.sshd import Sshd
    from bringup_lint.graph.host.sysctl import Sysctl
    from bringup_lint.graph.installed.scripts import Scripts
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.networkmanager.profiles import NetworkManager
    from bringup_lint.graph.nodes.nodes import Nodes
    from bringup_lint.graph.observed.expected import Expected
    from bringup_lint.graph.observed.observed import Observed
    from bringup_lint.graph.params.map_images import LostImage
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.params.questions.misspelt_words import MisspeltValue
    from bringup_lint.graph.plugins.plugins import Plugins
    from bringup_lint.graph.provenance import Provenance
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.graph.secrets.in_clear import Secret
    from bringup_lint.graph.secrets.in_clear import Secrets
    from bringup_lint.graph.secrets.ros import Indirect
    from bringup_lint.graph.set_aside import SetAside
    from bringup_lint.graph.sros2.sros2 import Sros2
    from bringup_lint.graph.supervision.notify import Notify
    from bringup_lint.graph.supervision.watchdog import Watchdog
    from bringup_lint.graph.switched_off import SwitchedOff
    from bringup_lint.graph.systemd.daemons import Daemon
    from bringup_lint.graph.systemd.filesystem import Filesystem
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.graph.target import Target
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.graph.udev.udev import Udev
    from bringup_lint.graph.uncalled import Uncalled
    from bringup_lint.graph.unincluded import Unincluded
    from bringup_lint.graph.unmade import Unmade
    from bringup_lint.graph.unreached import Unreached
    from bringup_lint.model.dockerfile import Dockerfile
    from bringup_lint.model.env_file import EnvFile
    from bringup_lint.model.firewall import Firewall
    from bringup_lint.model.fstab import Fstab
    from bringup_lint.model.netplan import Netplan
    from bringup_lint.model.observed import ObservedGraph
    from bringup_lint.model.shell import Command
    from bringup_lint.parsers.cloud_init import KeyImport
    from bringup_lint.parsers.cloud_init import Login
    from bringup_lint.source import Located
    from bringup_lint.source import Problem
    from bringup_lint.source import Source
    from bringup_lint.source import Span

Model = TypeVar("Model")

OF_SYNTAX = frozenset(
    (
        "closed_devices",
        "compared",
        "dependencies",
        "devices",
        "expected",
        "graph",
        "nodes",
        "observed",
        "open_services",
        "params",
        "sros2",
        "topics",
    )
)
"""What is answered from the syntax of nodes, or of the modules that they are made of."""
HOLDING_SYNTAX = ("nodes", "topics", "expected", "observed")
"""The layers that keep it."""


class Robot:
    """The files of one run and everything derived from them, each layer on first use."""

    def __init__(
        self,
        tree: Tree,
        configured_ros: str | None = None,
        configured_systemd: int | None = None,
        today: date | None = None,
        purposes: Mapping[str, str] | None = None,
    ) -> None:
        self.files = Files(tree, configured_ros, configured_systemd, purposes or {}, today)
        if self.files.of_kind("shell-script", "ansible", "cloud-init"):
            from bringup_lint.graph.installed.installed import join_installed

            join_installed(self.files, self.scripts)
        self.answers: dict[tuple[str, Any], bool] = {}
        """What it was asked for before rules were loaded, which need it to find anything."""
        self.launch_commands: tuple[str, ...] = ()
        """For a comparison with the running graph: what was launched, as after ``ros2 launch``."""

    def without(self, names: Collection[str]) -> Robot:
        """The same robot, of whose sources of these names nothing is known."""
        files = self.files
        robot = Robot(
            files.tree.without(names),
            files.configured_ros,
            files.configured_systemd,
            files.configured_today,
            files.configured_purposes,
        )
        robot.launch_commands = self.launch_commands
        return robot

    def let_go_of_syntax(self) -> None:
        """Forget the syntax of nodes, a sixth of the memory for a big repository, and the layers that know it, but for
        what a report may still ask of them. Whoever asks for more has them made again."""
        if "topics" in self.__dict__ and "entries" in self.topics.__dict__:
            with suppress(Exception):  # who asks for them later meets it again
                _ = self._topic_joins
        if "nodes" in self.__dict__:
            self.nodes.let_go()
        for name in HOLDING_SYNTAX:
            self.__dict__.pop(name, None)
        if self.of_kind("python-node"):
            from bringup_lint.parsers.python_node import let_go

            let_go(self.sources)

    def let_go_of_uncalled(self) -> None:
        """Forget the Python code that ``leads_to`` has read."""
        self.__dict__.pop("_uncalled", None)

    @property
    def tree(self) -> Tree:
        return self.files.tree

    @property
    def today(self) -> date:
        """The day for which validity dates are judged."""
        return self.files.today

    @property
    def failures(self) -> list[tuple[Source, Exception]]:
        """Sources on which a parser failed inside."""
        return self.files.failures

    @property
    def unfinished(self) -> list[Source]:
        """Sources whose parser took too long."""
        return self.files.unfinished

    @property
    def sources(self) -> list[Source]:
        return self.files.sources

    def join(self, source: Source) -> None:
        """Take in a source that comes later, of a kind that nothing asked for before."""
        self.files.join(source)

    def of_kind(self, *kinds: str) -> list[Source]:
        return self.files.of_kind(*kinds)

    def parsed(self, parse: Callable[[Source], Model], sources: Iterable[Source]) -> list[Model]:
        """The models of the sources; of none on which the parser fails."""
        return self.files.parsed(parse, sources)

    @property
    def kinds(self) -> frozenset[str]:
        """The kinds of file in the tree, and ``python-program`` where a unit, or a script beside units, names a Python
        file of the tree."""
        return self.files.kinds | {"python-program"} if self.files.names_python else self.files.kinds

    @property
    def has_launch_files(self) -> bool:
        """Whether ``launch`` has anything, so that it is worth loading."""
        return bool(self.of_kind(*LAUNCH))

    def mentions(self, pattern: re.Pattern[str]) -> bool:
        """Whether the text of a judged file matches."""
        return self.files.mentions(pattern)

    def may_hold(self, *words: str) -> bool:
        """Whether a file may hold one of some words; False saves the loading of the rule that asks first."""
        return self.files.may_hold(*words)

    @property
    def problems(self) -> list[Problem]:
        """What could not be read at all: unreadable, oversized or binary files."""
        return self.files.problems

    @property
    def target(self) -> Target:
        """The ROS distribution and the systemd version of the robot."""
        return self.files.target

    @property
    def is_ros(self) -> bool:
        """Whether the tree has to do with ROS 2."""
        return self.files.is_ros

    def same_robot(self, one: Source | Located, other: Source | Located) -> bool:
        """Whether two files may be joined though neither names the other: they are for the same robot."""
        return self.files.same_robot(one, other)

    def find(self, robot_path: str, asked_by: Source) -> Source | None:
        """The file at a path on the robot that another file names; none of another robot or variant."""
        return self.files.find(robot_path, asked_by)

    def environment_file(self, robot_path: str) -> EnvFile | None:
        """The environment file at a path on the robot, when the tree holds it."""
        return self.files.environment_file(robot_path)

    def leads_to(self, place: Source | Located | Span) -> bool:
        """Whether a place is in more than a part of a copy that nothing of the robot's own uses, of what the tree
        switches off, of what it keeps and does not use, of a header that nothing includes, of a class that nothing
        makes, or of code that never runs."""
        source = span_of(place).source
        if self._set_aside.has(source) or self._unincluded.has(source):
            return False
        if self._unmade.has(span_of(place)) or self._uncalled.has(span_of(place)):
            return False
        return not self.files.of_kind("ros-package") or not (
            self._unreached.has(source) or self._switched_off.has(source)
        )

    @cached_property
    def _set_aside(self) -> SetAside:
        from bringup_lint.graph.set_aside import SetAside

        return SetAside(self.files, lambda: self.compose)

    @cached_property
    def _unmade(self) -> Unmade:
        from bringup_lint.graph.unmade import Unmade

        return Unmade(self.files)

    @cached_property
    def _unincluded(self) -> Unincluded:
        from bringup_lint.graph.unincluded import Unincluded

        return Unincluded(self.files)

    @cached_property
    def _uncalled(self) -> Uncalled:
        from bringup_lint.graph.uncalled import Uncalled

        return Uncalled(self.files)

    @cached_property
    def _switched_off(self) -> SwitchedOff:
        from bringup_lint.graph.switched_off import SwitchedOff

        return SwitchedOff(self.files)

    @cached_property
    def _unreached(self) -> Unreached:
        from bringup_lint.graph.unreached import Unreached

        return Unreached(self.files)

    def purpose(self, place: Source | Located | Span) -> Purpose:
        """What a place of a file is for: by its path, by the service around it, by who builds or starts it."""
        own = self.files.purpose(place)
        span = span_of(place)
        if own is not Purpose.ROBOT:
            return own
        if span.source.kind in LAUNCH:
            file = self.launch.of_source(span.source)
            return Purpose.SIMULATION if file is not None and self.launch.simulated(file) else own
        return self.runners.purpose(span)

    @cached_property
    def scripts(self) -> Scripts:
        """The shell scripts, and what they do."""
        from bringup_lint.graph.installed.scripts import Scripts

        return Scripts(self.files)

    @cached_property
    def secrets(self) -> list[Secret]:
        """Secrets in clear text: in units, compose files, images, environment, parameter and launch files, programs."""
        return list(self._secrets.in_clear())

    @cached_property
    def exposed_secrets(self) -> list[Indirect]:
        """Parameters that hand a secret to a node."""
        return list(self._secrets.exposed())

    @cached_property
    def _secrets(self) -> Secrets:
        from bringup_lint.graph.secrets.in_clear import Secrets

        return Secrets(
            self.files,
            self.runners,
            units=lambda: self.units,
            dockerfiles=lambda: self.dockerfiles,
            launch=lambda: self.launch,
            params=lambda: self.params,
            scripts=lambda: self.scripts,
        )

    @cached_property
    def units(self) -> Units:
        from bringup_lint.graph.systemd.units import Units

        return Units(self.files, lambda: self.system_conf)

    @cached_property
    def filesystem(self) -> Filesystem:
        """What will be there on the running robot."""
        from bringup_lint.graph.systemd.filesystem import Filesystem

        return Filesystem(self.files, self.units, lambda: self.fstabs)

    @cached_property
    def env_files(self) -> list[UsedEnvFile]:
        from bringup_lint.graph.environment.env_files import used_env_files

        return used_env_files(self.files, self.units)

    @cached_property
    def netplan(self) -> Netplan:
        from bringup_lint.graph.netplan.netplan import load_netplan

        return load_netplan(self.files)

    @cached_property
    def networkmanager(self) -> NetworkManager:
        from bringup_lint.graph.networkmanager.profiles import load_networkmanager

        return load_networkmanager(self.files)

    @cached_property
    def sysctl(self) -> Sysctl:
        from bringup_lint.graph.host.sysctl import load_sysctl

        return load_sysctl(self.files)

    @cached_property
    def dds(self) -> Dds:
        from bringup_lint.graph.dds.dds import Dds

        return Dds(
            self.files,
            self.ros,
            units=lambda: self.units,
            netplan=lambda: self.netplan,
            networkmanager=lambda: self.networkmanager,
        )

    @cached_property
    def udev(self) -> Udev:
        from bringup_lint.graph.udev.udev import load_udev

        return load_udev(self.files)

    @cached_property
    def devices(self) -> Devices:
        from bringup_lint.graph.host.devices import Devices

        return Devices(
            self.files,
            udev=lambda: self.udev,
            units=lambda: self.units,
            compose=lambda: self.compose,
            launch=lambda: self.launch,
            params=lambda: self.params,
            python=lambda: self.nodes.with_modules,
        )

    @cached_property
    def closed_devices(self) -> list[ClosedDevice]:
        """The devices that services name and that their users may not open."""
        if not self.tree.complete or not self.of_kind("udev-rules"):
            return []
        from bringup_lint.graph.host.device_access import closed_devices

        return list(closed_devices(self.devices, self.units, self.accounts, lambda: self.launch, lambda: self.params))

    @cached_property
    def waiting_for_network(self) -> list[tuple[str, Located]]:
        """Units that are ordered after network-online.target, with the word that says so."""
        from bringup_lint.graph.systemd.network_online import waiting_for_network

        plan = self.netplan.only_plan
        found = waiting_for_network(self.units)
        return [each for each in found if plan is None or self.same_robot(each[1], plan.files[0].source)]

    @cached_property
    def notify(self) -> Notify:
        from bringup_lint.graph.supervision.notify import Notify

        return Notify(self.files, lambda: self.launch)

    @cached_property
    def launch(self) -> Launch:
        from bringup_lint.graph.launch.launch import Launch

        return Launch(self.files)

    @cached_property
    def dependencies(self) -> Dependencies:
        from bringup_lint.graph.dependencies.dependencies import Dependencies

        return Dependencies(self.files, self.launch, lambda: self.dockerfiles)

    @cached_property
    def nodes(self) -> Nodes:
        """The Python sources of nodes, and which of them a launch file starts."""
        from bringup_lint.graph.nodes.nodes import Nodes

        return Nodes(self.files, self.launch, lambda: self.runners, lambda: self.provenance)

    @cached_property
    def params(self) -> Params:
        from bringup_lint.graph.params.params import Params

        return Params(self.files, lambda: self.launch)

    @property
    def lost_map_images(self) -> Iterator[LostImage]:
        """Maps whose image does not exist, where their folder has one that no map names."""
        from bringup_lint.graph.params.map_images import lost_images

        return lost_images(self.files)

    @property
    def misspelt_words(self) -> Iterator[MisspeltValue]:
        """Values of parameter files, and of YAML files that programs read themselves, which are a letter away from the
        words that their program knows."""
        from bringup_lint.graph.params.questions.misspelt_words import misspelt_words

        return misspelt_words(self.params)

    @cached_property
    def plugins(self) -> Plugins:
        from bringup_lint.graph.plugins.plugins import Plugins

        return Plugins(self.files, self.launch, lambda: self.params)

    @cached_property
    def topics(self) -> Topics:
        """What launched nodes publish and subscribe, under full names."""
        from bringup_lint.graph.topics.topics import Topics

        return Topics(
            self.files,
            self.launch,
            self.nodes,
            params=lambda: self.params,
            ros=lambda: self.ros,
            units=lambda: self.units,
        )

    @cached_property
    def accounts(self) -> Accounts:
        from bringup_lint.graph.host.accounts import Accounts

        return Accounts(self.files, lambda: self.units)

    @cached_property
    def journald(self) -> list[Daemon]:
        return self._daemons("journald")

    @cached_property
    def system_conf(self) -> list[Daemon]:
        return self._daemons("system")

    @cached_property
    def logind(self) -> list[Daemon]:
        return self._daemons("logind")

    def _daemons(self, name: str) -> list[Daemon]:
        if not self.of_kind(f"{name}-conf"):
            return []
        from bringup_lint.graph.systemd.daemons import load_daemons

        return load_daemons(self.files, name)

    @cached_property
    def sshd(self) -> list[Sshd]:
        from bringup_lint.graph.host.sshd import load_sshd

        return load_sshd(self.files)

    @cached_property
    def watchdog(self) -> Watchdog:
        from bringup_lint.graph.supervision.watchdog import Watchdog

        return Watchdog(self.files, lambda: self.system_conf)

    @cached_property
    def logs(self) -> RosLogs:
        """What units and ROS write, and the logrotate files that rotate it."""
        from bringup_lint.graph.host.logs import RosLogs

        return RosLogs(self.files, lambda: self.units, lambda: self.mounts)

    @cached_property
    def compose(self) -> Compose:
        from bringup_lint.graph.containers.compose import load_compose

        return load_compose(self.files)

    @property
    def dockerfiles(self) -> list[Dockerfile]:
        """The Dockerfiles of the tree; a stage knows its base in another Dockerfile too."""
        return self.compose.images.dockerfiles if self.of_kind("dockerfile") else []

    @cached_property
    def firewalls(self) -> list[Firewall]:
        from bringup_lint.graph.host.firewall import load_firewalls

        return load_firewalls(self.files)

    @cached_property
    def ssh_forwards(self) -> list[tuple[Source, int, Located]]:
        """The ports that scripts forward over SSH, with the word that says so."""
        from bringup_lint.graph.host.ssh_commands import ssh_forwards

        return list(ssh_forwards(self.files))

    @property
    def user_data_logins(self) -> Iterator[Login]:
        """The users that cloud-init's user data lets log in with a password."""
        from bringup_lint.parsers.cloud_init import logins

        return (each for source in self.files.of_kind("cloud-init") if source.judged for each in logins(source))

    @property
    def user_data_key_imports(self) -> Iterator[KeyImport]:
        """The accounts whose keys cloud-init's user data imports from Launchpad and GitHub."""
        from bringup_lint.parsers.cloud_init import key_imports

        return (each for source in self.files.of_kind("cloud-init") if source.judged for each in key_imports(source))

    @cached_property
    def open_services(self) -> list[OpenService]:
        """Services of the robot that ask for no password, and that no address limits to the robot."""
        from bringup_lint.graph.host.open_services import OpenService
        from bringup_lint.graph.host.open_services import open_services

        found = list(open_services(self.files, self.runners, lambda: self.launch))
        if self.of_kind("python-node"):
            from bringup_lint.graph.nodes.questions.files.web_servers import web_servers

            found += [OpenService(*each) for each in web_servers(self.nodes)]
        return found

    @property
    def bare_jobs(self) -> Iterator[Located]:
        """Where crontabs, and lines that scripts add to them, start ROS without a setup file."""
        if not self.of_kind("cron", "shell-script"):
            return iter(())
        from bringup_lint.graph.runners.questions.crontabs import in_crontabs

        return in_crontabs(self.files, self.scripts)

    @property
    def ssh_logins(self) -> Iterator[tuple[str, Located, str | None]]:
        """``ssh USER@HOST`` and scp in scripts: the user, the word, and the port when it is known."""
        from bringup_lint.graph.host.ssh_commands import ssh_logins

        return ssh_logins(self.files)

    @cached_property
    def dds_domain(self) -> tuple[int, Located] | None:
        """The DDS domain that the tree sets, when all its files agree on one."""
        from bringup_lint.graph.environment.domain import agreed_domain

        return agreed_domain(self.files, self.ros)

    @cached_property
    def mounts(self) -> Mounts:
        """The file systems that fstab(5) mounts, and the units that need what lies on them."""
        from bringup_lint.graph.host.fstab import Mounts

        return Mounts(self.files, lambda: self.units)

    @property
    def fstabs(self) -> list[Fstab]:
        return self.mounts.fstabs

    @staticmethod
    def mount_options(filesystem: str) -> list[str]:
        """The mount options of a file system; empty when they are not known."""
        from bringup_lint.graph.host.fstab import mount_options

        return mount_options(filesystem)

    @cached_property
    def jails(self) -> list[Jail]:
        from bringup_lint.graph.host.fail2ban import parse_jail

        return self.parsed(parse_jail, self.of_kind("fail2ban-jail"))

    @cached_property
    def sshd_sources(self) -> list[Source]:
        from bringup_lint.graph.host.sshd import sshd_sources

        return sshd_sources(self.files)

    @cached_property
    def installations(self) -> list[tuple[Source, Command]]:
        """The commands of scripts and Dockerfiles that install packages with apt."""
        from bringup_lint.graph.host.apt import installations

        return list(installations(self.files, self.dockerfiles))

    @cached_property
    def can(self) -> Can:
        from bringup_lint.graph.host.can import Can

        return Can(self.files, self.units)

    @cached_property
    def graph(self) -> Graph:
        """Everything that the files of the tree name, and how it depends on each other: from units to topics."""
        from bringup_lint.graph.edges.joined import Layers
        from bringup_lint.graph.edges.joined import joined_graph

        return joined_graph(
            Layers(
                self.files,
                units=lambda: self.units,
                runners=lambda: self.runners,
                ros=lambda: self.ros,
                compose=lambda: self.compose,
                launch=lambda: self.launch,
                params=lambda: self.params,
                topic_joins=lambda: self._topic_joins,
                netplan=lambda: self.netplan,
                networkmanager=lambda: self.networkmanager,
                dds=lambda: self.dds,
                sros2=lambda: self.sros2,
                udev=lambda: self.udev,
                devices=lambda: self.devices,
            )
        )

    @cached_property
    def _topic_joins(self) -> Joins:
        from bringup_lint.graph.edges.topics import joins_of

        return joins_of(self.launch, self.topics)

    @cached_property
    def runners(self) -> Runners:
        """Whoever starts processes: units, compose services, images, cron's @reboot lines, scripts."""
        from bringup_lint.graph.runners.layers import Layers
        from bringup_lint.graph.runners.runners import Runners

        return Runners(self.files, Layers(lambda: self.units, lambda: self.compose), lambda: self.launch)

    @cached_property
    def ros(self) -> RosEnvironment:
        """The variables of ROS 2, wherever they are set, and the environment of every process that runs it."""
        from bringup_lint.graph.environment.ros import RosEnvironment

        return RosEnvironment(self.files, self.runners, lambda: self.units, lambda: self.compose, lambda: self.launch)

    @cached_property
    def sros2(self) -> Sros2:
        """Keystores, enclaves, governance and permissions documents, and the processes that use them."""
        from bringup_lint.graph.sros2.sros2 import Sros2

        return Sros2(
            self.files,
            self.ros,
            runners=lambda: self.runners,
            launch=lambda: self.launch,
            topics=lambda: self.topics,
            domain=lambda: self.dds_domain,
        )

    @cached_property
    def provenance(self) -> Provenance:
        """How things come into effect: the chain of lines from a unit to a place."""
        from bringup_lint.graph.provenance import Provenance

        return Provenance(
            self.runners,
            self.launch,
            params=lambda: self.params,
            dds=lambda: self.dds,
        )

    @cached_property
    def expected(self) -> Expected:
        """The nodes that the files start, for a comparison with the running graph."""
        from bringup_lint.graph.observed.expected import Sources

        sources = Sources(
            self.files,
            units=lambda: self.units,
            ros=lambda: self.ros,
            launch=self.launch,
            nodes=lambda: self.nodes,
            topics=self.topics,
        )
        return sources.expected(self.launch_commands)

    @cached_property
    def observed(self) -> Observed:
        """The running graph, compared with the files. Only the rules of ``live`` may ask: raises LookupError in a run
        that looks at files only."""
        from bringup_lint.parsers.observed import KIND
        from bringup_lint.parsers.observed import parse

        graphs = self.parsed(parse, self.of_kind(KIND))
        if not graphs:
            raise LookupError("no running graph was read")
        return self.compared(graphs[0])

    def compared(self, graph: ObservedGraph) -> Observed:
        """A running graph, compared with the files."""
        from bringup_lint.graph.observed.observed import Observed

        return Observed(
            graph,
            self.expected,
            self.ros,
            lambda: self.units,
            self.launch,
            self.topics,
            lambda: self.params,
            self.tree.complete,
        )
