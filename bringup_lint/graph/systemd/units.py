"""All units of a robot, with what they run, in which order and with which environment."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable
from collections.abc import Iterator
from functools import cached_property

from bringup_lint.dataclass import dataclass
from bringup_lint.facts.systemd.directives import NEWEST
from bringup_lint.facts.systemd.directives import SECTION_OF_TYPE
from bringup_lint.graph.commands.command_line import Step
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import stays_local
from bringup_lint.graph.commands.ros_command import Ros
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.graph import Node
from bringup_lint.graph.memo import memo
from bringup_lint.graph.systemd.boot import Boot
from bringup_lint.graph.systemd.cycles import ROOTS
from bringup_lint.graph.systemd.cycles import Cycle
from bringup_lint.graph.systemd.cycles import ordering_cycles
from bringup_lint.graph.systemd.dependencies import dependency_graph
from bringup_lint.graph.systemd.dependencies import stated_graph
from bringup_lint.graph.systemd.environment import EnvironmentFile
from bringup_lint.graph.systemd.environment import environment_files
from bringup_lint.graph.systemd.environment import process_environment
from bringup_lint.graph.systemd.environment import unit_environment
from bringup_lint.graph.systemd.forward import all_go_forward
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.process import processes
from bringup_lint.graph.systemd.relations import STARTING
from bringup_lint.graph.systemd.restart import RestartPolicy
from bringup_lint.graph.systemd.restart import restart_policy
from bringup_lint.graph.systemd.same_robot_groups import same_robot_groups
from bringup_lint.graph.systemd.sandbox import Sandbox
from bringup_lint.graph.systemd.stack_layers import layers
from bringup_lint.graph.systemd.supervision import Supervision
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.unit_lines import Line
from bringup_lint.graph.systemd.unit_lines import lines
from bringup_lint.graph.systemd.user_database import UserDatabase
from bringup_lint.graph.systemd.waits import Wait
from bringup_lint.graph.systemd.waits import longest_wait
from bringup_lint.model.unit import UnitFile
from bringup_lint.parsers.unit import LONGEST
from bringup_lint.parsers.unit import TOO_LONG
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Span

_DDS_VARIABLE = regex(r"(?:ROS|RMW|CYCLONEDDS|FASTRTPS|FASTDDS|ZENOH)_(?!VERSION$|PYTHON_VERSION$)")


_OF_ROS = regex(
    r"(?<![a-z])(?:micro)?ros(?:[12](?![0-9])|(?![a-z]))|launch|bring[-_ ]?up|\bnav2|moveit|gazebo"
    r"|\bnavigation\b|\brobot[ ](?:control|stack|software)\b",
    re.I,
)
_WORD = regex(r"[\w:.\\@-]+")
_WORD_START = regex(r"\b(?=\w)")
_TYPE = regex(rf"\.(?:target|{'|'.join(SECTION_OF_TYPE)})")
_LONGEST_WORD = 1000


@dataclass(eq=False)
class Units(NamedUnits):
    """All units with what follows from their settings."""

    @property
    def shadowed(self) -> list[tuple[UnitFile, Unit]]:
        """Files that a higher directory hides, with the unit that hides them."""
        return self.loaded.shadowed

    @property
    def orphans(self) -> list[UnitFile]:
        """Drop-ins of units that neither the tree nor the distribution has."""
        return self.loaded.orphans

    @property
    def loose(self) -> list[UnitFile]:
        """Drop-ins of single instances and of groups of units that the tree does not hold."""
        return self.loaded.loose

    @cached_property
    def unit_files(self) -> list[UnitFile]:
        """All unit files and drop-ins that systemd reads, as written, judged ones only."""
        found = [*(file for unit in self.all for file in unit.files), *self.loose]
        return list(dict.fromkeys(file for file in found if file.source.judged))

    def problems(self, code: str) -> Iterator[tuple[UnitFile, Problem]]:
        """What systemd cannot read in unit files and drop-ins, by code."""
        for file in self.unit_files:
            yield from ((file, problem) for problem in file.problems if problem.code == code)

    @property
    def endless_lines(self) -> Iterator[Located | Span]:
        """The starts of lines for whose length systemd refuses their files."""
        if any(len(source.text) > LONGEST for source in self.files.sources):
            problems = (problem for file in self.unit_files for problem in file.problems)
            yield from (problem.where for problem in problems if problem.code == TOO_LONG)

    @cached_property
    def keys(self) -> frozenset[str]:
        """Every key that a unit sets or resets."""
        return frozenset(str(line.key) for unit in self.all for file in unit.files for line in file.assignments)

    @cached_property
    def judged(self) -> list[Unit]:
        """The units that rules about effective settings look at."""
        return [unit for unit in self.all if unit.judged and not unit.masked and unit.files]

    @cached_property
    def lines(self) -> list[Line]:
        """Every judged line with a key that its section knows, and what systemd finds wrong with its
        value. Lines that the unit takes back later are left out."""
        target = self.files.target
        reset = {line.span for unit in self.all for line in unit.reset_lines}
        found = lines(self.unit_files, target.systemd if target.systemd_known else NEWEST)
        return [line for line in found if line.assignment.span not in reset]

    @cached_property
    def wrong_lines(self) -> list[Line]:
        """Those of ``lines`` with whose value something is wrong."""
        return [line for line in self.lines if line.problems]

    def mount_name(self, unit: Unit, where: str) -> str:
        """The name that a mount or automount unit of this path must have."""
        from bringup_lint.parsers.systemd_values import escape_path

        return f"{escape_path(where)}.{unit.type}"

    @property
    def services(self) -> list[Unit]:
        return [unit for unit in self.judged if unit.type == "service"]

    @memo
    def environment(self, unit: Unit) -> Environment:
        """What systemd gives to the processes of a unit. Do not change it."""
        return unit_environment(unit, self.files)

    @memo
    def environment_files(self, unit: Unit) -> list[EnvironmentFile]:
        """The environment files of a unit, in the order in which they are read."""
        return environment_files(unit, self.files)

    def process_environment(self, process: Process, until: Step | None = None) -> Environment:
        """The environment of a command line of a unit, or of one step of what its shells and scripts run."""
        return process_environment(process, self.environment(process.unit), self.files, until)

    def stays_local(self, unit: Unit) -> bool:
        """Whether everything that the unit starts talks to this machine only."""
        found = [self.process_environment(process) for process in self.started(unit)]
        return bool(found) and all(map(stays_local, found))

    @memo
    def restart(self, unit: Unit) -> RestartPolicy:
        """What systemd does when the service ends."""
        return restart_policy(unit, self.files.target.systemd, self.system_conf)

    def fails_each_time(self, unit: Unit) -> bool:
        """Whether a service that is restarted counts as failed before each restart, so that OnFailure= starts."""
        return self.files.target.systemd >= 254 and unit.get("RestartMode") != "direct"

    @memo
    def supervision(self, unit: Unit) -> Supervision:
        """How systemd starts, watches and stops the service."""
        started = self.started(unit)
        return Supervision(unit, self.files, self.system_conf, started[0] if len(started) == 1 else None)

    @memo
    def sandbox(self, unit: Unit) -> Sandbox:
        """What the service may see and write."""
        return Sandbox(unit)

    @cached_property
    def users(self) -> UserDatabase:
        """/etc/passwd and /etc/group of the tree."""
        return UserDatabase(self.files)

    @memo
    def never_ends(self, process: Process) -> Located | None:
        """What of a command line runs until it is stopped; None when it may end."""
        from bringup_lint.graph.systemd.endless import never_ends

        return never_ends(process, self.files)

    def longest_wait(self, process: Process) -> Wait:
        """How long a command line may wait, by the loops and sleeps of its shells and scripts."""
        return longest_wait(process, self.files)

    @cached_property
    def triggered(self) -> frozenset[str]:
        """The names of the units that a timer or path unit of the tree starts: jobs, not daemons."""
        found = set()
        for unit in self.all:
            if unit.type in ("timer", "path"):
                found.add(str(unit.get("Unit") or f"{unit.stem}.service"))
        return frozenset(found)

    @memo
    def processes(self, unit: Unit) -> list[Process]:
        """The command lines of a service with what they run."""
        return processes(unit, self.files)

    def running(self, word: str) -> list[Unit]:
        """The services with a command line that holds a word, itself or a script that it starts."""
        return [unit for unit in self.services if self._runs(unit, word)]

    def _runs(self, unit: Unit, word: str) -> bool:
        return any(word in text for process in self.processes(unit) for text in process.texts)

    def started(self, unit: Unit) -> list[Process]:
        """The command lines of ExecStart= alone."""
        return [process for process in self.processes(unit) if process.key == "ExecStart"]

    @cached_property
    def stated(self) -> Graph:
        """The edges of the units and links of the tree."""
        return stated_graph(self)

    @cached_property
    def graph(self) -> Graph:
        """Requirement and ordering edges of all units, the distribution's included."""
        return dependency_graph(self.stated, self)

    @cached_property
    def cycles(self) -> list[Cycle]:
        if all_go_forward(self.stated, self):
            return []
        default = self.alias_links.get(("system", "default.target"))
        return list(ordering_cycles(self.graph, self.boot.components, [default] if default else ROOTS))

    @cached_property
    def ros(self) -> list[Unit]:
        """The services that start something of ROS 2."""
        return [unit for unit in self.services if any(process.mentions_ros for process in self.processes(unit))]

    @cached_property
    def ros1(self) -> list[Unit]:
        """The services that start something of ROS 1 and nothing of ROS 2."""
        started = ((unit, self.processes(unit)) for unit in self.services if unit not in self.ros)
        return [unit for unit, found in started if any(process.is_ros1 for process in found)]

    @cached_property
    def dds(self) -> list[Unit]:
        """The services that take part in ROS 2's communication: they start it, or their environment
        configures it."""
        ros1 = [unit for unit in self.ros if all(p.is_ros1 for p in self.processes(unit) if p.mentions_ros)]
        return [
            unit
            for unit in self.services
            if unit not in ros1
            and (unit in self.ros or any(_DDS_VARIABLE.match(name) for name in self.environment(unit).chains))
        ]

    @cached_property
    def presumed_ros(self) -> list[Unit]:
        """Services of a ROS 2 tree that run a shell script which the tree does not hold, where a name or the
        description speaks of ROS: most likely ROS too."""
        if not self.files.is_ros:
            return []
        return [
            unit
            for unit in self.services
            if unit not in self.dds
            and unit not in self.ros
            and unit.get("Type") != "oneshot"
            and any(process.script_outside_tree for process in self.started(unit))
            and _speaks_of_ros(unit, self.started(unit))
        ]

    @cached_property
    def planned_ros(self) -> list[Unit]:
        """Services that do not start ROS yet: a comment of their script says that they will."""
        known = {*self.dds, *self.presumed_ros}
        started = ((unit, self.processes(unit)) for unit in self.services if unit not in known)
        return [unit for unit, found in started if any(process.plans_ros for process in found)]

    @cached_property
    def enabled_ros_groups(self) -> list[list[Unit]]:
        """The ROS services of one place that are enabled somewhere, so that they may run together."""
        places: dict[str, list[Unit]] = {}
        for unit in self.ros:
            if unit.manager == "system" and not unit.is_template and any(True for _ in self.wanted_by(unit)):
                places.setdefault(unit.place, []).append(unit)
        return [units for units in places.values() if len(units) > 1]

    def same_robot_groups(self, chosen: Iterable[Unit]) -> list[list[Unit]]:
        """Units in groups that surely belong to one robot."""
        return same_robot_groups(self, chosen, self.processes)

    @cached_property
    def running_together(self) -> list[list[Unit]]:
        """The groups of ROS services that surely run together: enabled, and of one robot."""
        groups = (group for enabled in self.enabled_ros_groups for group in self.same_robot_groups(enabled))
        return [group for group in groups if len(group) > 1]

    def conflict(self, one: Unit, other: Unit) -> bool:
        """Whether the two never run at the same time."""
        return other.name in one.words("Conflicts") or one.name in other.words("Conflicts")

    def any_conflict(self, group: list[Unit]) -> bool:
        """Whether any two of a group never run at the same time."""
        count = Counter(unit.name for unit in group)
        named = ((unit, word) for unit in group for word in unit.words("Conflicts"))
        return any(count[word] > (word == unit.name) for unit, word in named)

    def layers(self, units: list[Unit]) -> dict[str, str]:
        """Unit name -> layer of the robot's stack, for those whose names tell one."""
        return layers(units)

    @cached_property
    def launching(self) -> frozenset[Unit]:
        """The services whose main process is ``ros2 launch``."""
        return frozenset(unit for unit, _ in self.launch)

    @cached_property
    def launch(self) -> list[tuple[Unit, Process]]:
        """The services whose main process is ``ros2 launch``, with the command line that starts it."""
        return [
            (unit, process)
            for unit in self.ros
            for process in self.started(unit)
            if process.launches and process.replaces_shell
        ]

    def launches(self, unit: Unit) -> list[Ros]:
        """Every ``ros2 launch`` that the main processes of a service run."""
        return [ros for process in self.started(unit) for _, ros in process.launches]

    def is_started(self, unit: Unit) -> bool:
        """Whether something starts the unit, or can be told to: an [Install] section that is not empty, another unit,
        D-Bus, a udev rule."""
        installed = any(section.assignments for section in unit.sections("Install"))
        if unit.is_template or unit.aliases or unit.get("BusName") or installed:
            return True
        if self.is_distribution_unit(unit.name) or unit.name.startswith("systemd-"):
            return True
        edges = self.graph.into.get(self.node(unit), ())
        return any(edge.kind in STARTING for edge in edges) or unit.name in self._named_by_udev

    def awaits_device(self, unit: Unit, name: str) -> bool:
        """Whether a device unit has a start job that the unit can wait for, or the device is what starts the unit."""
        device = Node("unit" if unit.manager == "system" else "user-unit", name)
        pulling = self.graph.into.get(device, ())
        by_device = (edge for edge in self.graph.into.get(self.node(unit), ()) if edge.source == device)
        if any(edge.kind in STARTING for edge in (*pulling, *by_device)):
            return True
        return unit.is_template or unit.name in self._named_by_udev

    @cached_property
    def _named_by_udev(self) -> frozenset[str]:
        """Everything in udev rules that can be the name of a unit."""
        return frozenset(name for source in self.files.of_kind("udev-rules") for name in _unit_names(source.text))

    @cached_property
    def boot(self) -> Boot:
        return Boot(self, self.stated, lambda: self.graph)

    def waits_for(self, unit: Unit, name: str) -> Edge | None:
        """The edge at the named unit by which the other, in the end, starts after it; None when it does not."""
        return self.boot.waits_for(unit, name)

    def ordered(self, unit: Unit, name: str) -> bool:
        """Whether the two units have an order at all, whichever is first."""
        return self.boot.ordered(unit, name)

    def brings_in(self, unit: Unit, name: str) -> bool:
        """Whether starting the unit starts the named one too."""
        return self.boot.brings_in(unit, name)

    def brought_in(self, near: Unit, name: str) -> bool:
        """Whether the named unit starts at boot, whatever ``near`` says."""
        return self.boot.brought_in(near, name)


def _speaks_of_ros(unit: Unit, started: Iterable[Process]) -> bool:
    texts = [unit.stem, unit.get("Description", "Unit") or "", *(str(process.line) for process in started)]
    return any(_OF_ROS.search(text) for text in texts)


def _unit_names(text: str) -> Iterator[str]:
    """The parts of words that start where a word may start and end with the type of a unit."""
    for word in _WORD.findall(text):
        if len(word) > _LONGEST_WORD:
            continue
        for suffix in _TYPE.finditer(word):
            for start in _WORD_START.finditer(word, 0, suffix.start()):
                yield word[start.start() : suffix.end()]
