"""Which processes read which Cyclone DDS configuration: ``CYCLONEDDS_URI`` of units and compose services,
resolved."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from bringup_lint.dataclass import dataclass
from bringup_lint.dataclass import field
from bringup_lint.parsers.cyclonedds_uri import split_uri
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Source
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.commands.environment import Environment
    from bringup_lint.graph.commands.environment import Variable
    from bringup_lint.graph.environment.ros import RosEnvironment
    from bringup_lint.graph.environment.ros import RosProcess
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units

URI = "CYCLONEDDS_URI"
PROFILES = {
    "2": ("FASTRTPS_DEFAULT_PROFILES_FILE",),
    "3": ("FASTDDS_DEFAULT_PROFILES_FILE",),
}
"""The variable that names the profiles file, by the major version of Fast DDS."""

_TO_FILL = regex(r"\{\{[ \t]*(\w+)[ \t]*\}\}", hints="{{")


@dataclass(eq=False)
class Selection:
    """What the environment of one process says about Cyclone DDS."""

    process: RosProcess
    uri: Located
    """The value that takes effect."""
    files: list[Source] = field(default_factory=list)
    """The files of the list that the tree holds, in order."""
    inline: list[Located] = field(default_factory=list)
    complete: bool = True
    """Every part of the list is known."""
    domain: int | None = None
    """ROS_DOMAIN_ID as it really is; None when nobody knows."""
    domain_where: Located | None = None
    processes: int = 1
    """At least so many processes take part: what its launch files start by default."""


def selections(files: Files, ros: RosEnvironment) -> Iterator[Selection]:
    """Every process that surely reads a configuration."""
    apart = {each.node for process in ros.processes for each in process.launched}
    for process in ros.processes:
        variable = process.environment.get(URI)
        if variable is None or not _reads_it(process.environment):
            continue
        if variable.text is not None:
            yield _selection(files, ros, process, variable, apart)
        elif (file := _filled_alike(files, variable.value)) is not None:
            yield Selection(process, variable.value, [file])


def _filled_alike(files: Files, uri: Located) -> Source | None:
    """The file that the tree puts at a path of which a template fills in a folder, in both places alike."""
    path = _TO_FILL.sub(r"{{ \1 }}", uri)
    file = files.find(path, uri.span.source) if "{{ " in path else None
    return file if file is not None and file.robot_path == path else None


def _selection(
    files: Files, ros: RosEnvironment, process: RosProcess, variable: Variable, apart: set[Started]
) -> Selection:
    selection = Selection(process, variable.value)
    if variable.text == variable.value:
        _resolve(selection, variable.value, partial(_seen_by, files, process, variable.value))
    else:
        selection.complete = False
    _domain(selection, process.environment)
    selection.processes = _processes(ros, process, apart)
    return selection


def _seen_by(files: Files, process: RosProcess, value: Located, path: str) -> Source | None:
    """The file at a path as a process sees it: inside a container only what is mounted or copied there."""
    if process.runner is not None and process.runner.in_container:
        return process.runner.reads(path)
    return files.find(path, value.span.source)


def profile_selections(files: Files, ros: RosEnvironment, version: str) -> Iterator[tuple[RosProcess, Located, Source]]:
    """Every process that reads a Fast DDS profiles file of the tree, with the value that names it."""
    for process in ros.processes:
        rmw = process.environment.text("RMW_IMPLEMENTATION")
        if rmw is not None and "fastrtps" not in rmw:
            continue
        for name in PROFILES[version[0]]:
            variable = process.environment.get(name)
            if variable is None or variable.text is None or not variable.text.startswith("/"):
                continue
            file = _seen_by(files, process, variable.value, variable.text)
            if file is not None:
                yield process, variable.value, file


def _domain(selection: Selection, environment: Environment) -> None:
    variable = environment.get("ROS_DOMAIN_ID")
    if variable is None:
        selection.domain = 0 if environment.complete else None
    elif variable.text is not None and re.fullmatch(r"[1-9]?[0-9]{1,2}", variable.text):
        selection.domain, selection.domain_where = int(variable.text), variable.value


def _reads_it(environment: Environment) -> bool:
    rmw = environment.text("RMW_IMPLEMENTATION")
    return rmw is None or "cyclone" in rmw


def _resolve(selection: Selection, uri: Located, find: Callable[[str], Source | None]) -> None:
    for part in split_uri(uri):
        if part.inline:
            selection.inline.append(part.text)
            continue
        file = find(str(part.text)) if part.text.startswith("/") else None
        if file is None:
            selection.complete = False
        else:
            selection.files.append(file)


def _processes(ros: RosEnvironment, process: RosProcess, apart: set[Started]) -> int:
    """A lower bound: components share the process of their container, and those ``apart`` are counted there."""
    if process.launched:
        return sum(each.node.is_node for each in process.launched)
    count = 0
    for start in process.starts:
        expansion = ros.expansion(start)
        nodes = expansion.nodes if expansion is not None else []
        count += 1 if expansion is None else sum(_is_own_process(node) for node in nodes if node not in apart)
    return max(count, 1)


def _is_own_process(node: Started) -> bool:
    """Whether a node surely starts, in a process of its own."""
    return node.by_default is True and not node.conditions and node.is_node and node.container is None


NO_SHARED_MEMORY = (
    "FASTRTPS_DEFAULT_PROFILES_FILE",
    "FASTDDS_DEFAULT_PROFILES_FILE",
    "FASTDDS_BUILTIN_TRANSPORTS",
    "RMW_FASTRTPS_USE_QOS_FROM_XML",
)
"""Variables by which shared memory may be switched off."""


def sharing_memory(ros: RosEnvironment) -> Iterator[RosProcess]:
    """The unit processes that surely talk over Fast DDS shared memory in the common IPC namespace."""
    for process in ros.processes:
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
        if unit.flag("PrivateIPC").value is not True:
            yield process


def user_of(unit: Unit) -> tuple[str, Located | Span]:
    """The user of a service, and the place that says so."""
    identity = unit.identity
    if identity.dynamic and identity.dynamic.at is not None:
        return f"a user of its own ({unit.name})", identity.dynamic.at
    if identity.user is None or identity.user == "0":
        return "root", unit.where
    return identity.name or str(identity.user), identity.user


def largest_coexisting_group(units: Units, readers: list[Selection]) -> list[Selection]:
    """Of these processes, the most that surely run at the same time: one alone, or the units of one boot."""
    groups = [[each] for each in readers]
    groups += [[each for each in readers if each.process.unit in crew] for crew in units.running_together]
    return max(groups, key=lambda group: sum(each.processes for each in group), default=[])
