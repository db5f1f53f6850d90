"""Ports that a container publishes and on which none of its programs listens."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING

from bringup_lint.graph.commands.ros_command import ros_command
from bringup_lint.graph.commands.shells import SHELLS
from bringup_lint.graph.commands.wrappers import program_name
from bringup_lint.graph.commands.wrappers import unwrapped
from bringup_lint.graph.purpose import Purpose
from bringup_lint.model.compose_ports import Published
from bringup_lint.model.compose_ports import published
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.model.shell import Command
    from bringup_lint.source import Located

_SERVERS = {
    "rosbridge_server": ("rosbridge", 9090, ("rosbridge_websocket_launch.xml", "rosbridge_websocket")),
    "foxglove_bridge": ("foxglove_bridge", 8765, ("foxglove_bridge_launch.xml", "foxglove_bridge")),
    "web_video_server": ("web_video_server", 8080, ("web_video_server",)),
}
"""Packages of servers of one TCP port, which their argument or parameter ``port`` sets: the name, the port without
it, and the launch file and executable. Source: rosbridge_websocket_launch.xml, foxglove_bridge_launch.xml,
web_video_server.cpp."""
_KNOWN = frozenset("source . export set cd sleep echo printf test [ [[ mkdir true : trap wait ulimit umask".split()) | {
    *SHELLS,
    "ros_entrypoint.sh",
}
"""Listen on nothing themselves; what shells run are steps of their own."""
_PORT = regex(r"[1-9]\d{0,4}")
_FILES = ("--params-file", "--config", "--port")
_AGENTS = ("micro_ros_agent", "micro-ros-agent", "MicroXRCEAgent")
_TRANSPORTS = ("udp4", "udp6", "tcp4", "tcp6")
"""Also the first word that the image microros/micro-ros-agent is given."""


class Listener(NamedTuple):
    """A program that listens on one port."""

    name: str
    port: int
    protocol: str
    where: Located
    """What sets the port, else what starts the program."""


class Unserved(NamedTuple):
    """A published port behind which nothing listens."""

    runner: Runner
    entry: Published
    listener: Listener


def unserved_ports(runners: Iterable[Runner]) -> Iterator[Unserved]:
    """The first published port of each container all of whose programs are known, and listen on others."""
    for runner in runners:
        service = runner.service
        if service is None or service.network_mode is not None or runner.purpose is not Purpose.ROBOT:
            continue
        entries = list(published(service))
        if not entries or len(entries) != _written(runner):
            continue
        listening = _listeners(runner)
        if not listening or any(_serves(each, entry) for each in listening for entry in entries):
            continue
        yield Unserved(runner, entries[0], listening[0])


def _written(runner: Runner) -> int:
    """The number of entries of ``ports:``, those of unknown ports included."""
    node = runner.service.get("ports") if runner.service is not None else None
    return len(getattr(node, "items", ()))


def _serves(listener: Listener, entry: Published) -> bool:
    return listener.port in entry.inside and listener.protocol == entry.protocol


def _listeners(runner: Runner) -> list[Listener]:
    """What listens in a container; nothing where a program of it is not known."""
    found = []
    for line in runner.lines:
        if line.opaque or (line.line != line.program and program_name(line.line) not in _KNOWN):
            return []
        for step in line.steps:
            words = unwrapped(step.command.words)
            if words and program_name(words[0]) in _KNOWN:
                continue
            listener = _listener(step.command, words) if words else None
            if listener is None:
                return []
            found.append(listener)
    return found


def _listener(command: Command, words: tuple[Located, ...]) -> Listener | None:
    if any(program_name(word) in _AGENTS for word in words[:5]) or words[0] in _TRANSPORTS:
        return _agent(words)
    ros = ros_command(command)
    server = _SERVERS.get(str(ros.package)) if ros is not None else None
    if ros is None or server is None or ros.kind not in ("launch", "run") or str(ros.target) not in server[2]:
        return None
    return _server(ros, *server[:2])


def _server(ros: Ros, name: str, port: int) -> Listener | None:
    """A bridge or video server; None where a file or a variable may set its port."""
    if any(word in _FILES or "$" in word for word in ros.arguments):
        return None
    given = [word for word in ros.arguments if word.startswith(("port:=", "_port:="))]
    if not given:
        return Listener(name, port, "tcp", ros.where)
    value = given[-1].partition(":=")[2]
    return Listener(name, int(value), "tcp", given[-1]) if _PORT.fullmatch(value) else None


def _agent(words: tuple[Located, ...]) -> Listener | None:
    """The agent of micro-ROS: ``udp4 --port 8888``."""
    transport = next((word for word in words if word in _TRANSPORTS), None)
    for option, value in pairwise(words):
        if transport is not None and option in ("-p", "--port") and _PORT.fullmatch(value):
            return Listener("micro-ROS agent", int(value), transport[:3], value)
    return None
