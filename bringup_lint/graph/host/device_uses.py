"""The device paths that files of the robot name, by the kind of file."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bringup_lint.addresses import is_address
from bringup_lint.facts.systemd.directives import directive
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.parsers.systemd_values import unescape_path
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import Literal

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.systemd.units import Units
    from bringup_lint.model.launch import Action
    from bringup_lint.model.launch_values import Value
    from bringup_lint.model.params import ParameterFile

_ADDRESS = regex(r"(?:.*[._])?(?:ip|ip_?addr(?:ess)?|host(?:_?name)?)", re.I)
_HOST = regex(r"[A-Za-z][\w-]*(?:\.[\w-]+)+")
_GIVEN = regex(r"(?:^|^[ \t]*[-\w.]+[ \t]*[:=][ \t]*[\"']?)(?P<path>/dev/[\w./:+-]+)[\"']?[ \t]*$", re.M)
"""A path that is a whole value, or that of a key in a file which is written as one."""
_BUS = "/dev/bus/usb/"
"""The devices here have numbers only: a mapping of one opens it for whatever looks for it by its properties."""
_PATH = regex(r"(?<![\w./$}])/dev/[A-Za-z][\w.+-]*(?:/[\w.:+-]+)*")


OF_VARIABLES = {"ansible-vars": "a variable of Ansible", "driver-config": "the configuration of a driver"}
"""Kinds of file that hold variables -> who opens the devices that they name, in words."""

Certainty = Literal["literal", "unit", "host", "script", "default", "argument"]
"""``unit`` for the name of a device unit, ``host`` for a device that a container is handed; ``script``, ``default`` and
``argument`` (the default of a launch argument) when it may be only one of several values."""


class DeviceUse(NamedTuple):
    """One place that names a path below /dev."""

    path: Located
    user: str
    """Who opens it, in words."""
    certainty: Certainty = "literal"
    opened: Span | None = None
    """The call of a source that opens it."""

    @property
    def opened_elsewhere(self) -> Span | None:
        """That call, where another file holds the path."""
        is_elsewhere = self.opened is not None and self.opened.source is not self.path.span.source
        return self.opened if is_elsewhere else None


def uses_in(text: Located, user: str, certainty: Certainty = "literal") -> Iterator[DeviceUse]:
    """The device paths inside a text; what a shell puts in for an unset variable is a default."""
    for found in _PATH.finditer(text):
        default = text.endswith((":-", "-"), 0, found.start()) and "${" in text[: found.start()]
        if default and certainty != "argument":
            yield DeviceUse(text.part(*found.span()), user, "default")
        else:
            yield DeviceUse(text.part(*found.span()), user, certainty)


def of_units(units: Units) -> Iterator[DeviceUse]:
    """Uses in lines that systemd knows, in the environment of units and in their scripts."""
    for unit in units.judged:
        for file in unit.files:
            for section in file.sections:
                for assignment in section.assignments:
                    if directive(section.name, assignment.key) is not None:
                        yield from uses_in(assignment.value, unit.name)
                        yield from _of_device_units(assignment.value, unit.name)
        for variable in units.environment(unit):
            yield from uses_in(variable.value, unit.name)
        for process in units.processes(unit):
            for step in process.steps:
                if step.script is None:
                    continue
                for word in (*step.command.words, *step.command.assignments):
                    yield from uses_in(word, f"the script of {unit.name}", "script")


def device_path(unit: str) -> str | None:
    """The path below /dev that a ``.device`` name stands for; None for other names."""
    if not unit.startswith("dev-") or not unit.endswith(".device") or "%" in unit:
        return None
    return unescape_path(unit[: -len(".device")])


def _of_device_units(value: Located, user: str) -> Iterator[DeviceUse]:
    for word in value.words():
        path = device_path(word)
        if path is not None:
            yield DeviceUse(Located(path, word.span), user, "unit")


def of_compose(compose: Compose) -> Iterator[DeviceUse]:
    for service in compose.services:
        user = f"the service {service.name}"
        for device in service.devices:
            # Docker skips a mapping of a privileged container, which has all devices, to the same path.
            is_skipped = service.is_privileged and device.target in (None, device.host)
            if not (is_skipped and device.host.startswith(_BUS)):
                yield from uses_in(device.host, user, "host")
        texts = [volume.source for volume in service.volumes if volume.source is not None]
        texts += [variable.value for variable in service.environment.values() if variable.value is not None]
        for text in (*texts, *service.command, *service.entrypoint):
            yield from uses_in(text, user)


def of_env_files(compose: Compose, files: Files) -> Iterator[DeviceUse]:
    """Files that compose reads: those that services name, and the ``.env`` beside a compose file."""
    from bringup_lint.parsers.env_file import parse

    named = [files.tree.beside(file.source, ".env") for file in compose.files]
    named += [source for service in compose.services for source in compose.env_files(service)]
    for model in files.parsed(parse, dict.fromkeys(source for source in named if source is not None)):
        for entry in model.entries:
            yield from uses_in(entry.value, "the containers")


def of_params(params: Params) -> Iterator[DeviceUse]:
    from bringup_lint.model.yaml_node import Scalar

    networked: dict[int, set[int]] = {}
    for file, parameter in params.parameters:
        if "/dev/" not in parameter.text or (params.loads(file) and not params.effective(file, parameter)):
            continue
        if id(file) not in networked:
            networked[id(file)] = _on_network(file)
        if id(parameter.block) in networked[id(file)] or params.is_unknown_to_code(file, parameter):
            continue
        nodes = parameter.node.items if hasattr(parameter.node, "items") else [parameter.node]
        for node in nodes:
            if isinstance(node, Scalar) and "/dev/" in node.value:
                yield from uses_in(node.value, f"{parameter.block.name}")


def _on_network(file: ParameterFile) -> set[int]:
    """The blocks that give the driver the network address of its device, so that it opens no port."""
    hosts = ((each.block, each.text.strip("'\"")) for each in file.parameters if _ADDRESS.fullmatch(each.name))
    return {id(block) for block, host in hosts if is_address(host) or _HOST.fullmatch(host)}


def of_launch(launch: Launch) -> Iterator[DeviceUse]:
    for file in launch.judged:
        declared = _with_default(file.actions)
        for action in _all_actions(file.actions):
            yield from _of_action(action, declared)


def _all_actions(actions: tuple[Action, ...]) -> Iterator[Action]:
    from bringup_lint.model.launch import walk_actions

    return walk_actions(actions)


def _with_default(actions: tuple[Action, ...]) -> frozenset[str]:
    """The launch arguments that are declared with a default: what else is said of their default never counts."""
    from bringup_lint.model.launch import DeclareArgument
    from bringup_lint.model.launch_values import literal

    found = (action for action in _all_actions(actions) if isinstance(action, DeclareArgument) and action.default)
    return frozenset(str(name) for action in found if (name := literal(action.name)) is not None)


def _of_action(action: Action, declared: frozenset[str]) -> Iterator[DeviceUse]:
    from bringup_lint.model.launch import ComposableNode
    from bringup_lint.model.launch import DeclareArgument
    from bringup_lint.model.launch import Include
    from bringup_lint.model.launch import Node

    if isinstance(action, DeclareArgument):
        yield from _of_value(action.default, "the launch argument", "argument", declared)
    if isinstance(action, Include):
        for _, value in action.arguments:
            yield from _of_value(value, "a launch file", "literal", declared)
    if isinstance(action, (Node, ComposableNode)):
        values = (*action.parameters, *(action.arguments if isinstance(action, Node) else ()))
        for value in values:
            yield from _of_value(value, "a node", "literal", declared)
        if isinstance(action, Node):
            for component in action.components:
                yield from _of_action(component, declared)


def _of_value(value: Value | None, user: str, certainty: Certainty, declared: frozenset[str]) -> Iterator[DeviceUse]:
    from bringup_lint.model.launch_values import Argument
    from bringup_lint.model.launch_values import Env
    from bringup_lint.model.launch_values import children
    from bringup_lint.model.launch_values import literal

    if value is None or (isinstance(value, Argument) and value.name in declared):
        return
    text = literal(value)
    if text is not None:
        yield from uses_in(text, user, certainty)
    inner: Certainty = "default" if certainty != "argument" and isinstance(value, (Argument, Env)) else certainty
    for child in children(value):
        yield from _of_value(child, user, inner, declared)


def of_descriptions(files: Files) -> Iterator[DeviceUse]:
    """The devices that robot descriptions give to the hardware of ros2_control."""
    from bringup_lint.parsers.urdf import parse

    for description in files.parsed(parse, (each for each in files.of_kind("urdf") if each.judged)):
        for name, value in description.parameters:
            if value.startswith("/dev/"):
                yield DeviceUse(value, f"the hardware parameter {name}")


def of_variables(files: Files) -> Iterator[DeviceUse]:
    """The devices that the variables of Ansible and of drivers name; those of a role are only its defaults."""
    from bringup_lint.model.yaml_node import Scalar
    from bringup_lint.parsers.yaml_nodes import parse

    sources = [each for each in files.of_kind(*OF_VARIABLES) if each.judged and "/dev/" in each.text]
    for file in files.parsed(parse, sources):
        certainty: Certainty = "argument" if "/defaults/" in file.source.name else "literal"
        user = OF_VARIABLES[file.source.kind]
        for node in file.nodes:
            if isinstance(node, Scalar) and "/dev/" in node.value:
                for given in _GIVEN.finditer(node.value):
                    yield from uses_in(node.value.part(*given.span("path")), user, certainty)
