"""All units of a robot, with what they run, in which order and with which environment."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from dataclasses import field
from functools import cached_property

from bringup_lint.facts.systemd.directives import NEWEST
from bringup_lint.graph.commands.environment import Environment
from bringup_lint.graph.commands.environment import stays_local
from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Graph
from bringup_lint.graph.systemd import boot
from bringup_lint.graph.systemd.companions import companions
from bringup_lint.graph.systemd.cycles import ROOTS
from bringup_lint.graph.systemd.cycles import Cycle
from bringup_lint.graph.systemd.cycles import ordering_cycles
from bringup_lint.graph.systemd.dependencies import dependency_graph
from bringup_lint.graph.systemd.environment import EnvironmentFile
from bringup_lint.graph.systemd.environment import environment_files
from bringup_lint.graph.systemd.environment import process_environment
from bringup_lint.graph.systemd.environment import unit_environment
from bringup_lint.graph.systemd.named_units import NamedUnits
from bringup_lint.graph.systemd.process import Process
from bringup_lint.graph.systemd.process import processes
from bringup_lint.graph.systemd.restart import RestartPolicy
from bringup_lint.graph.systemd.restart import restart_policy
from bringup_lint.graph.systemd.stack_layers import layers
from bringup_lint.graph.systemd.supervision import Supervision
from bringup_lint.graph.systemd.supervision import supervision
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.unit_lines import Line
from bringup_lint.graph.systemd.unit_lines import lines
from bringup_lint.graph.systemd.waits import Wait
from bringup_lint.graph.systemd.waits import longest_wait
from bringup_lint.model.unit import UnitFile

_STARTING = frozenset({"requires", "binds-to", "wants", "upholds", "triggers", "on-failure", "on-success"})
_DDS_VARIABLE = re.compile(r"(?:ROS|RMW|CYCLONEDDS|FASTRTPS|FASTDDS|ZENOH)_(?!VERSION$|PYTHON_VERSION$)")


@dataclass(eq=False)
class Units(NamedUnits):
    """All units with what follows from their settings."""

    shadowed: list[tuple[UnitFile, Unit]] = field(default_factory=list)
    """Files that a higher directory hides, with the unit that hides them."""
    orphans: list[UnitFile] = field(default_factory=list)
    """Drop-ins of units that neither the tree nor the distribution has."""
    loose: list[UnitFile] = field(default_factory=list)
    """Drop-ins of single instances and of groups of units that the tree does not hold."""
    files: list[UnitFile] = field(default_factory=list)
    """All unit files and drop-ins that systemd reads, as written, judged ones only."""

    @cached_property
    def judged(self) -> list[Unit]:
        """The units that rules about effective settings look at."""
        return [unit for unit in self.all if unit.judged and not unit.masked and unit.files]

    @cached_property
    def lines(self) -> list[Line]:
        """Every judged line with a key that its section knows, and what systemd finds wrong with its
        value."""
        target = self.robot.target
        return list(lines(self.files, target.systemd if target.systemd_known else NEWEST))

    def mount_name(self, unit: Unit, where: str) -> str:
        """The name that a mount or automount unit of this path must have."""
        from bringup_lint.parsers.systemd_values import escape_path

        return f"{escape_path(where)}.{unit.type}"

    @property
    def services(self) -> list[Unit]:
        return [unit for unit in self.judged if unit.type == "service"]

    @cached_property
    def _environments(self) -> dict[int, Environment]:
        return {}

    def environment(self, unit: Unit) -> Environment:
        """What systemd gives to the processes of a unit. Do not change it."""
        if id(unit) not in self._environments:
            self._environments[id(unit)] = unit_environment(unit, self.robot)
        return self._environments[id(unit)]

    def environment_files(self, unit: Unit) -> list[EnvironmentFile]:
        """The environment files of a unit, in the order in which they are read."""
        return environment_files(unit, self.robot)

    def stays_local(self, unit: Unit) -> bool:
        """Whether everything that the unit starts talks to this machine only."""
        found = [process_environment(process, self.robot) for process in self.started(unit)]
        return bool(found) and all(map(stays_local, found))

    @cached_property
    def _policies(self) -> dict[int, RestartPolicy]:
        return {}

    def restart(self, unit: Unit) -> RestartPolicy:
        """What systemd does when the service ends."""
        if id(unit) not in self._policies:
            self._policies[id(unit)] = restart_policy(unit, self.robot)
        return self._policies[id(unit)]

    @cached_property
    def _supervisions(self) -> dict[int, Supervision]:
        return {}

    def supervision(self, unit: Unit) -> Supervision:
        """How systemd starts, watches and stops the service."""
        if id(unit) not in self._supervisions:
            self._supervisions[id(unit)] = supervision(unit, self.robot)
        return self._supervisions[id(unit)]

    def longest_wait(self, process: Process) -> Wait:
        """How long a command line may wait, by the loops and sleeps of its shells and scripts."""
        return longest_wait(process, self.robot)

    @cached_property
    def triggered(self) -> frozenset[str]:
        """The names of the units that a timer or path unit of the tree starts: jobs, not daemons."""
        found = set()
        for unit in self.all:
            if unit.type in ("timer", "path"):
                found.add(str(unit.get("Unit") or f"{unit.stem}.service"))
        return frozenset(found)

    @cached_property
    def _processes(self) -> dict[int, list[Process]]:
        return {}

    def processes(self, unit: Unit) -> list[Process]:
        """The command lines of a service with what they run."""
        if id(unit) not in self._processes:
            self._processes[id(unit)] = processes(unit, self.robot.files)
        return self._processes[id(unit)]

    def started(self, unit: Unit) -> list[Process]:
        """The command lines of ExecStart= alone."""
        return [process for process in self.processes(unit) if process.key == "ExecStart"]

    @cached_property
    def graph(self) -> Graph:
        """Requirement and ordering edges of all units, the distribution's included."""
        return dependency_graph(self)

    @cached_property
    def cycles(self) -> list[Cycle]:
        default = self.alias_links.get(("system", "default.target"))
        return list(ordering_cycles(self.graph, [default] if default else ROOTS))

    @cached_property
    def ros(self) -> list[Unit]:
        """The services that start something of ROS 2."""
        return [unit for unit in self.services if any(process.mentions_ros for process in self.processes(unit))]

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
        """Services of a ROS 2 tree that run a shell script which the tree does not hold: most likely ROS
        too."""
        if not self.robot.is_ros:
            return []
        return [
            unit
            for unit in self.services
            if unit not in self.dds
            and unit not in self.ros
            and unit.get("Type") != "oneshot"
            and any(process.lost_script for process in self.started(unit))
        ]

    @cached_property
    def stacks(self) -> list[list[Unit]]:
        """The ROS services of one place that are enabled somewhere, so that they may run together."""
        places: dict[str, list[Unit]] = {}
        for unit in self.ros:
            if unit.manager == "system" and not unit.is_template and any(True for _ in self.wanted_by(unit)):
                places.setdefault(unit.place, []).append(unit)
        return [units for units in places.values() if len(units) > 1]

    def companions(self, chosen: Iterable[Unit]) -> list[list[Unit]]:
        """Units in groups that surely belong to one robot."""
        return companions(self, chosen)

    @cached_property
    def crews(self) -> list[list[Unit]]:
        """The ROS services that surely run together: of one stack, and of one robot."""
        return [crew for stack in self.stacks for crew in self.companions(stack) if len(crew) > 1]

    def conflict(self, one: Unit, other: Unit) -> bool:
        """Whether the two never run at the same time."""
        return other.name in one.words("Conflicts") or one.name in other.words("Conflicts")

    def layers(self, units: list[Unit]) -> dict[str, str]:
        """Unit name -> layer of the robot's stack, for those whose names tell one."""
        return layers(units)

    @cached_property
    def launch(self) -> list[tuple[Unit, Process]]:
        """The services whose main process is ``ros2 launch``, with the command line that starts it."""
        return [
            (unit, process)
            for unit in self.ros
            for process in self.started(unit)
            if process.launches and process.replaces_shell
        ]

    def is_started(self, unit: Unit) -> bool:
        """Whether something starts the unit, or can be told to: an [Install] section, another unit, D-Bus,
        a udev rule."""
        if unit.is_template or unit.aliases or unit.get("BusName") or any(unit.sections("Install")):
            return True
        if self.is_distribution_unit(unit.name) or unit.name.startswith("systemd-"):
            return True
        edges = self.graph.into.get(self.node(unit), ())
        if any(edge.kind in _STARTING for edge in edges):
            return True
        name = re.escape(unit.name)
        return any(re.search(rf"\b{name}", source.text) for source in self.robot.of_kind("udev-rules"))

    def waits_for(self, unit: Unit, name: str) -> list[Edge] | None:
        """The chain of ordering by which the unit starts after the named one; None when there is none."""
        return boot.waits_for(self, unit, name)

    def ordered(self, unit: Unit, name: str) -> bool:
        """Whether the two units have an order at all, whichever is first."""
        return boot.ordered(self, unit, name)

    def brings_in(self, unit: Unit, name: str) -> list[Edge] | None:
        """The chain by which starting the unit starts the named one too; None when there is none."""
        return boot.brings_in(self, unit, name)

    def brought_in(self, near: Unit, name: str) -> list[Edge] | None:
        """The chain by which the named unit starts at boot, whatever ``near`` says."""
        return boot.brought_in(self, near, name)
