"""Devices that the nodes of a container open, and that the container does not have."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.purpose import Purpose
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.launch.started import Started
    from bringup_lint.graph.params.params import Params
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.udev.udev import Udev
    from bringup_lint.model.compose import Service
    from bringup_lint.source import Located

_LINKS = regex(r"/dev/(?:serial|v4l|input)/by-(?:id|path)/[\w.:+-]+")
"""Links that packaged rules make."""
_SERIAL = regex(r"/dev/tty(?:USB|ACM|AMA|THS)\d+")

_NETWORK = regex(r"(?:^|[._])(?:channel_type|transport|connection)[\w.]*$", hints="channel_type transport connection")
"""Parameters that choose between a serial line and a network."""
_STAND_IN = regex(r"(?:^|[._])(?:mock|fake|dummy|sim|simulated?|simulation)(?:[._]|$)(?!time)")
"""Parameters by which a node does without its device."""


class Ungiven(NamedTuple):
    service: Service
    path: Located
    """As the parameter names it."""
    link: Located | None
    """The name in the rule of the tree that makes it."""
    is_link: bool


class _Layers(NamedTuple):
    files: Files
    compose: Compose
    udev: Udev
    launch: Launch
    params: Params


def ungiven_devices(
    files: Files, runners: Iterable[Runner], compose: Compose, udev: Udev, launch: Launch, params: Params
) -> Iterator[Ungiven]:
    """The first such device of each service whose launch files the tree holds."""
    layers = _Layers(files, compose, udev, launch, params)
    for runner in runners:
        service = runner.service
        if service is None or not runner.launches:
            continue
        purposes = (Purpose.ROBOT, Purpose.DEVELOPMENT) if service.is_privileged else (Purpose.ROBOT,)
        if runner.purpose not in purposes:
            continue
        if not _is_whole(layers.compose, service):
            continue
        given = _given(service)
        found = (each for path in _opened(layers, runner) if (each := _ungiven(layers, service, path, given)))
        first = next(found, None)
        if first is not None:
            yield first


def _is_whole(compose: Compose, service: Service) -> bool:
    """Whether one file says all of a service."""
    is_alone = len(compose.services_called(str(service.name))) == 1
    return is_alone and service.source.judged and not compose.extends_elsewhere(service)


def _given(service: Service) -> list[str]:
    """The paths of the container that are devices of the host, or folders of them."""
    given = [str(path) for device in service.devices for path in (device.host, device.target) if path is not None]
    given += [str(path) for volume in service.volumes for path in (volume.source, volume.target) if path is not None]
    return [path.rstrip("/") for path in given if path.startswith("/dev") or "$" in path]


def _ungiven(layers: _Layers, service: Service, path: Located, given: list[str]) -> Ungiven | None:
    if any("$" in each or path == each or path.startswith(f"{each}/") for each in given):
        return None
    made = [link for link in layers.udev.links_to(path) if link.is_fixed and layers.files.same_robot(link.name, path)]
    is_link = bool(made) or _LINKS.fullmatch(path) is not None
    is_node = not service.is_privileged and _SERIAL.fullmatch(path) is not None
    if not is_link and not is_node:
        return None
    return Ungiven(service, path, made[0].name if made else None, is_link)


def _opened(layers: _Layers, runner: Runner) -> Iterator[Located]:
    """The device paths in the parameters of the nodes that a container starts in any case."""
    from bringup_lint.graph.params.loads import loads_in
    from bringup_lint.graph.runners.launching import expansion_of

    launch = layers.launch
    for start in runner.launches:
        expansion = expansion_of(start.ros, launch)
        if expansion is None:
            continue
        yield from _of_launch(expansion)
        params = layers.params
        for load in loads_in(launch, expansion):
            file = params.at_path(load.path) if load.certain and _opens(load.node) else None
            if file is None:
                continue
            idle = {each.block for each in file.parameters if _is_idle(str(each.name), each.value.data)}
            for parameter in file.parameters:
                path = _path(parameter.node)
                if path is not None and parameter.block not in idle and params.effective(file, parameter):
                    yield path


def _of_launch(expansion: Expansion) -> Iterator[Located]:
    from bringup_lint.model.launch_values import literal

    for _, value in (pair for node in expansion.nodes if _opens(node) for pair in node.given):
        text = literal(value)
        if text is not None and text.startswith("/dev/"):
            yield text


def _opens(node: Started) -> bool:
    """Whether a node is started by default, and its launch file does not tell it to do without its device."""
    from bringup_lint.model.launch_values import Literal
    from bringup_lint.model.launch_values import TypedValue
    from bringup_lint.model.launch_values import literal

    for name, value in node.given:
        inner = value.value if isinstance(value, TypedValue) else value
        if isinstance(inner, Literal) and _is_idle(str(literal(name)), inner.value):
            return False
    return bool(node.by_default)


def _is_idle(name: str, data: object) -> bool:
    """Whether a parameter says that its node opens no device: it has a network instead, or stands in for one."""
    value = str(data).lower()
    if name.endswith("use_serial"):
        return value == "false"
    if _NETWORK.search(name):
        return value.startswith(("udp", "tcp"))
    return value == "true" and _STAND_IN.search(name) is not None


def _path(node: object) -> Located | None:
    from bringup_lint.model.yaml_node import Scalar

    return node.value if isinstance(node, Scalar) and node.value.startswith("/dev/") else None
