"""Device paths that files of the robot use, joined to the udev rules that make them."""

from __future__ import annotations

import re
from collections.abc import Callable
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING
from typing import NamedTuple

from bringup_lint.parsers.systemd_values import escape_path
from bringup_lint.parsers.systemd_values import unescape_path
from bringup_lint.source import Located
from bringup_lint.spelling import nearest

if TYPE_CHECKING:
    from bringup_lint.graph.udev.rule import Link
    from bringup_lint.model.launch import Action
    from bringup_lint.robot import Robot

_PATH = re.compile(r"(?<![\w./$}])/dev/[A-Za-z][\w.+-]*(?:/[\w.:+-]+)*")
_BY_DISCOVERY = re.compile(r"/dev/(?:ttyUSB\d+|ttyACM\d+|video\d)")
_SIMULATION = re.compile(r"(?:^|[/_.-])(?:sim|simulation|gazebo|gz|ignition|webots|isaac)(?:[/_.-]|$)", re.I)
_OF_KERNEL = frozenset(
    [
        "block",
        "bus",
        "char",
        "cpu",
        "disk",
        "dma_heap",
        "dri",
        "fd",
        "hugepages",
        "infiniband",
        "input",
        "iio",
        "mapper",
        "mqueue",
        "mtd",
        "net",
        "pts",
        "serial",
        "shm",
        "snd",
        "usb",
        "v4l",
        "vfio",
        "vg",
        "xen",
    ]
)
"""Folders of /dev that the kernel, systemd or the packaged udev rules fill."""


class DeviceUse(NamedTuple):
    """One place that names a path below /dev."""

    path: Located
    user: str
    """Who opens it, in words."""
    certainty: str = "literal"
    """``literal``, ``unit`` for the name of a device unit, ``host`` for a device that a container is handed;
    ``script`` and ``default`` when it may be only one of several values."""


class Meant(NamedTuple):
    link: Link
    unit: str
    """The name of its device unit."""


@dataclass(frozen=True, eq=False)
class Devices:
    """All uses of device paths in units with their scripts and environments, compose and launch files."""

    robot: Robot

    @cached_property
    def uses(self) -> tuple[DeviceUse, ...]:
        found: dict[tuple[int, int], DeviceUse] = {}
        for kinds, collect in COLLECTORS:
            for use in collect(self.robot) if self.robot.of_kind(*kinds) else ():
                simulated = _SIMULATION.search(use.path.span.path)
                if not simulated and (use.certainty == "host" or use.path not in self._inside_containers):
                    found.setdefault((id(use.path.span.source), use.path.span.start), use)
        return tuple(found.values())

    @cached_property
    def _inside_containers(self) -> frozenset[str]:
        """Paths that compose gives to devices inside a container, other than their own."""
        if not self.robot.of_kind("compose"):
            return frozenset()
        from bringup_lint.model.compose import split

        mappings = [split(device.where) for service in self.robot.compose.services for device in service.devices]
        return frozenset(str(parts[1]) for parts in mappings if len(parts) > 1 and parts[0] != parts[1])

    @property
    def unstable(self) -> Iterator[tuple[DeviceUse, list[Link]]]:
        """Uses of a name that changes with the order of discovery, with the links that may be meant."""
        for use in self.uses:
            if _BY_DISCOVERY.fullmatch(use.path):
                yield use, [link for link in self.robot.udev.stable_names(use.path) if self._is_near(link, use)]

    @property
    def undefined(self) -> Iterator[tuple[DeviceUse, Link | None]]:
        """Uses of a link that no rule makes in a folder where rules make links, with the nearest one."""
        if not self.uses:
            return
        for use in (use for use in self.uses if use.path.count("/") > 2):
            own = [link for link in self.robot.udev.links if link.is_fixed and self._is_near(link, use)]
            folders = {link.path.rpartition("/")[0] for link in own} - {"/dev"}
            names = {link.path: link for link in own}
            escaped = use.certainty == "unit" and self.meant_by(use.path.span.text) is not None
            if use.path.rpartition("/")[0] in folders and not escaped and not self.robot.udev.links_to(use.path):
                near = nearest(use.path, names)
                yield use, names[near[0]] if len(near) == 1 else None

    def _is_near(self, link: Link, use: DeviceUse) -> bool:
        """Whether the rule that makes a link is for the robot on which it is used."""
        return self.robot.same_robot(link.name, use.path)

    def untagged(self, unit: str) -> list[Link]:
        """The links behind a ``.device`` name when none of their devices becomes a device unit."""
        if not self.robot.of_kind("udev-rules"):
            return []
        links = [link for link in self.robot.udev.links_to(device_path(unit) or "") if link.is_fixed]
        return links if links and not any(self._is_device_unit(link) for link in links) else []

    def _is_device_unit(self, link: Link) -> bool:
        """Whether systemd hears of the device, for sure or perhaps."""
        rule = link.rule
        tagged = rule.is_tagged_by_systemd(self.robot.target.systemd) is not False
        return tagged or self.robot.udev.set_of(rule).sets_beside(rule, "TAG", "systemd")

    def meant_by(self, unit: str) -> Meant | None:
        """The link that a ``.device`` name was to stand for, when its dashes make it mean another path."""
        path = device_path(unit) if self.robot.of_kind("udev-rules") else None
        if path is None or "/" not in path or self.robot.udev.links_to(path):
            return None
        for link in self.robot.udev.links:
            if link.is_fixed and "-" in link.path and link.path.replace("-", "/") == path:
                return Meant(link, escape_path(link.path) + ".device")
        return None

    @property
    def without_rules(self) -> Iterator[DeviceUse]:
        """Uses of a link in a folder of one's own, in a tree without any udev rule."""
        if self.robot.of_kind("udev-rules") and self.robot.udev.rules:
            return
        for use in self.uses:
            parts = use.path.split("/")
            if len(parts) > 3 and parts[2] not in _OF_KERNEL:
                yield use


def uses_in(text: Located, user: str, certainty: str = "literal") -> Iterator[DeviceUse]:
    """The device paths inside a text; what a shell puts in for an unset variable is a default."""
    for found in _PATH.finditer(text):
        default = text.endswith((":-", "-"), 0, found.start()) and "${" in text[: found.start()]
        yield DeviceUse(text.part(*found.span()), user, "default" if default else certainty)


def _of_units(robot: Robot) -> Iterator[DeviceUse]:
    for unit in robot.units.judged:
        for file in unit.files:
            for assignment in file.assignments:
                yield from uses_in(assignment.value, unit.name)
                yield from _of_device_units(assignment.value, unit.name)
        for variable in robot.units.environment(unit):
            yield from uses_in(variable.value, unit.name)
        for process in robot.units.processes(unit):
            for step in process.steps:
                for word in (*step.command.words, *step.command.assignments) if step.script else ():
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


def _of_compose(robot: Robot) -> Iterator[DeviceUse]:
    for service in robot.compose.services:
        user = f"the service {service.name}"
        for device in service.devices:
            yield from uses_in(device.host, user, "host")
        texts = [volume.source for volume in service.volumes if volume.source is not None]
        texts += [variable.value for variable in service.environment.values() if variable.value is not None]
        for text in (*texts, *service.command, *service.entrypoint):
            yield from uses_in(text, user)


def _of_env_files(robot: Robot) -> Iterator[DeviceUse]:
    """Files that compose reads: those that services name, and the ``.env`` beside a compose file."""
    from bringup_lint.parsers.env_file import parse

    files = [robot.tree.beside(file.source, ".env") for file in robot.compose.files]
    files += [source for service in robot.compose.services for source in robot.compose.env_files(service)]
    for model in robot.parsed(parse, {id(source): source for source in files if source is not None}.values()):
        for entry in model.entries:
            yield from uses_in(entry.value, "the containers")


def _of_params(robot: Robot) -> Iterator[DeviceUse]:
    from bringup_lint.model.yaml_node import Scalar

    for file, parameter in robot.params.parameters:
        if "/dev/" not in parameter.text or (robot.params.loads(file) and not robot.params.effective(file, parameter)):
            continue
        nodes = parameter.node.items if hasattr(parameter.node, "items") else [parameter.node]
        for node in nodes:
            if isinstance(node, Scalar) and "/dev/" in node.value:
                yield from uses_in(node.value, f"{parameter.block.name}")


def _of_launch(robot: Robot) -> Iterator[DeviceUse]:
    for file in robot.launch.judged:
        for action in _all_actions(file.actions):
            yield from _of_action(action)


def _all_actions(actions: tuple[Action, ...]) -> Iterator[Action]:
    from bringup_lint.model.launch import walk_actions

    return walk_actions(actions)


def _of_action(action: Action) -> Iterator[DeviceUse]:
    from bringup_lint.model.launch import ComposableNode
    from bringup_lint.model.launch import DeclareArgument
    from bringup_lint.model.launch import Node

    if isinstance(action, DeclareArgument):
        yield from _of_value(action.default, "the launch argument", "default")
    if isinstance(action, (Node, ComposableNode)):
        values = (*action.parameters, *(action.arguments if isinstance(action, Node) else ()))
        for value in values:
            yield from _of_value(value, "a node", "literal")
        for component in action.components if isinstance(action, Node) else ():
            yield from _of_action(component)


def _of_value(value, user: str, certainty: str) -> Iterator[DeviceUse]:
    from bringup_lint.model.launch_values import Argument
    from bringup_lint.model.launch_values import Env
    from bringup_lint.model.launch_values import children
    from bringup_lint.model.launch_values import literal

    if value is None:
        return
    text = literal(value)
    if text is not None:
        yield from uses_in(text, user, certainty)
    inner = "default" if isinstance(value, (Argument, Env)) else certainty
    for child in children(value):
        yield from _of_value(child, user, inner)


Collector = Callable[["Robot"], Iterator[DeviceUse]]
COLLECTORS: tuple[tuple[tuple[str, ...], Collector], ...] = (
    (("systemd-unit", "systemd-dropin"), _of_units),
    (("compose",), _of_compose),
    (("compose",), _of_env_files),
    (("launch-python", "launch-xml", "launch-ros1", "launch-yaml"), _of_launch),
    (("params",), _of_params),
)
"""Who looks for uses, and the kinds of file without which there is nothing to look for."""


def load_devices(robot: Robot) -> Devices:
    return Devices(robot)
