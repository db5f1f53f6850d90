"""Which processes read which Cyclone DDS configuration: ``CYCLONEDDS_URI`` of units and compose services,
resolved."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from dataclasses import field
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.graph.systemd.environment import process_environment
from bringup_lint.parsers.cyclonedds_uri import split_uri
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.systemd.environment import Environment
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.model.compose import Service
    from bringup_lint.robot import Robot

URI = "CYCLONEDDS_URI"
PROFILES = {
    "2": ("FASTRTPS_DEFAULT_PROFILES_FILE",),
    "3": ("FASTDDS_DEFAULT_PROFILES_FILE",),
}
"""The variable that names the profiles file, by the major version of Fast DDS."""


@dataclass(eq=False)
class Selection:
    """One process of the robot, and what its environment says about Cyclone DDS."""

    who: str
    """``robot.service``, or ``service base`` of a compose file."""
    where: Located
    """The command line of the unit, or the name of the service."""
    uri: Located
    """The value that counts."""
    files: list[Source] = field(default_factory=list)
    """The files of the list that the tree holds, in order."""
    inline: list[Located] = field(default_factory=list)
    complete: bool = True
    """Every part of the list is known."""
    domain: int | None = None
    """ROS_DOMAIN_ID as it really is; None when nobody knows."""
    domain_where: Located | None = None
    unit: Unit | None = None
    service: Service | None = None
    processes: int = 1
    """At least so many processes take part: what the launch files of the unit start by default."""


def selections(robot: Robot) -> Iterator[Selection]:
    """Every process that surely reads a configuration."""
    apart = [process for process in robot.ros.processes if process.launched]
    own = {id(process.unit or process.service) for process in robot.ros.processes if not process.launched}
    elsewhere = {id(each.node) for process in apart for each in process.launched}
    all_apart = {id(process.unit or process.service) for process in apart} - own
    for selection in (*_of_units(robot, elsewhere), *_of_services(robot)):
        if id(selection.unit or selection.service) not in all_apart:
            yield selection
    yield from _of_launched(robot, apart)


def profile_selections(robot: Robot, version: str) -> Iterator[tuple[RosProcess, Located, Source]]:
    """Every process that reads a Fast DDS profiles file of the tree, with the value that names it."""
    for process in robot.ros.processes:
        rmw = process.environment.text("RMW_IMPLEMENTATION")
        if rmw is not None and "fastrtps" not in rmw:
            continue
        for name in PROFILES[version[0]]:
            variable = process.environment.get(name)
            if variable is None or variable.text is None or not variable.text.startswith("/"):
                continue
            if process.service is not None:
                file = _mounted(robot, process.service, variable.text)
            else:
                file = robot.find(variable.text, variable.value.span.source)
            if file is not None:
                yield process, variable.value, file


def _of_launched(robot: Robot, apart: list[RosProcess]) -> Iterator[Selection]:
    """The processes to which launch gives an environment of their own."""
    for process in apart:
        environment, service = process.environment, process.service
        variable = environment.get(URI)
        if variable is None or variable.text is None or not _reads_it(environment.text("RMW_IMPLEMENTATION")):
            continue
        place = process.where.source.located(process.where.start, process.where.end)
        selection = Selection(process.name, place, variable.value, unit=process.unit, service=service)
        if variable.text == variable.value:
            _resolve(selection, variable.value, partial(_mounted, robot, service) if service else robot.tree.find)
        else:
            selection.complete = False
        _domain(selection, environment)
        selection.processes = sum(each.node.is_node for each in process.launched)
        yield selection


def _of_units(robot: Robot, elsewhere: set[int]) -> Iterator[Selection]:
    for unit in robot.units.dds:
        for process in robot.units.started(unit):
            environment = process_environment(process, robot)
            variable = environment.get(URI)
            if variable is None or variable.text is None or not _reads_it(environment.text("RMW_IMPLEMENTATION")):
                continue
            selection = Selection(unit.name, process.line, variable.value, unit=unit)
            if variable.text == variable.value:
                _resolve(selection, variable.value, partial(robot.find, asked_by=variable.value.span.source))
            else:
                selection.complete = False
            _domain(selection, environment)
            selection.processes = _processes(robot, process.launches, elsewhere) if process.mentions_ros else 0
            yield selection


def _domain(selection: Selection, environment: Environment) -> None:
    variable = environment.get("ROS_DOMAIN_ID")
    if variable is None:
        selection.domain = 0 if environment.complete else None
    elif variable.text is not None and re.fullmatch(r"[1-9]?[0-9]{1,2}", variable.text):
        selection.domain, selection.domain_where = int(variable.text), variable.value


def _of_services(robot: Robot) -> Iterator[Selection]:
    for service in robot.compose.services:
        values = dict(robot.compose.variables(service, URI, "RMW_IMPLEMENTATION", "ROS_DOMAIN_ID"))
        uri = values.get(URI)
        if uri is None or "$" in uri or not _reads_it(values.get("RMW_IMPLEMENTATION")):
            continue
        selection = Selection(f"service {service.name}", service.name, uri, service=service)
        _resolve(selection, uri, lambda path, service=service: _mounted(robot, service, path))
        domain = values.get("ROS_DOMAIN_ID")
        if domain is not None and re.fullmatch(r"[1-9]?[0-9]{1,2}", domain):
            selection.domain, selection.domain_where = int(domain), domain
        yield selection


def _mounted(robot: Robot, service: Service, path: str) -> Source | None:
    """The file that a bind mount puts at a path of the container."""
    for volume in service.volumes:
        if volume.target is None or volume.source is None or "$" in volume.source:
            continue
        target = str(volume.target).rstrip("/")
        if path == target or path.startswith(f"{target}/"):
            below = f"{volume.source.rstrip('/')}{path[len(target) :]}"
            return robot.tree.find(below) if below.startswith("/") else robot.tree.beside(service.source, below)
    return None


def _reads_it(rmw: str | None) -> bool:
    return rmw is None or "cyclone" in rmw


def _resolve(selection: Selection, uri: Located, find: object) -> None:
    for part in split_uri(uri):
        if part.inline:
            selection.inline.append(part.text)
            continue
        file = find(str(part.text)) if part.text.startswith("/") else None
        if file is None:
            selection.complete = False
        else:
            selection.files.append(file)


def _processes(robot: Robot, launches: list, elsewhere: set[int]) -> int:
    """A lower bound: components share the process of their container, and those ``elsewhere`` are counted there."""
    count = 0
    for _, command in launches:
        file = robot.launch.named(command.package, command.target)
        if file is None:
            count += 1
            continue
        started = robot.launch.expansion(file).nodes
        count += sum(
            node.by_default is True and not node.conditions and node.is_node and node.container is None
            for node in started
            if id(node) not in elsewhere
        )
    return max(count, 1)


NO_SHARED_MEMORY = (
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "RMW_FASTRTPS_USE_QOS_FROM_XML",
)
"""Variables by which shared memory may be switched off."""


def sharing_memory(robot: Robot) -> Iterator[RosProcess]:
    """The unit processes that surely talk over Fast DDS shared memory in the common IPC namespace."""
    for process in robot.ros.processes:
        environment, unit = process.environment, process.unit
        if unit is None or environment.text("RMW_IMPLEMENTATION") not in (
            "rmw_fastrtps_cpp",
            "rmw_fastrtps_dynamic_cpp",
        ):
            continue
        if any(environment.defines(name) is not False for name in NO_SHARED_MEMORY):
            continue
        if unit.unsure_of("User", "DynamicUser", "PrivateIPC", section="Service") or unit.has("IPCNamespacePath"):
            continue
        if (unit.get("PrivateIPC") or "no").lower() in ("no", "false", "off", "0"):
            yield process


def user_of(unit: Unit) -> tuple[str, Located | Span]:
    """The user of a service, and the place that says so."""
    user = unit.get("User")
    dynamic = unit.get("DynamicUser")
    if dynamic is not None and dynamic.lower() in ("yes", "true", "on", "1"):
        return f"a user of its own ({unit.name})", dynamic
    if not user or user == "0":
        return "root", unit.where
    return str(user), user


def together(robot: Robot, readers: list[Selection]) -> list[Selection]:
    """Of these processes, the most that surely run at the same time: one alone, or the units of one boot."""
    groups = [[each] for each in readers]
    groups += [[each for each in readers if each.unit in units] for units in robot.units.crews]
    return max(groups, key=lambda group: sum(each.processes for each in group), default=[])
