"""Services that everybody on the network may use: no password is asked, and no address limits them to the robot."""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Callable
from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.addresses import is_wildcard
from bringup_lint.discover.kinds.launch import LAUNCH
from bringup_lint.graph.commands.open_access import Offer
from bringup_lint.graph.commands.open_access import open_access
from bringup_lint.graph.modules import modules
from bringup_lint.graph.purpose import Purpose
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.runners.runner import Runner
    from bringup_lint.graph.runners.runner import Start
    from bringup_lint.graph.runners.runners import Runners
    from bringup_lint.model.compose import Service
    from bringup_lint.source import Located
    from bringup_lint.source import Source
    from bringup_lint.source import Span

BRIDGES = frozenset({"rosbridge_server", "foxglove_bridge"})
"""Packages whose server gives the graph to every client, on all addresses by default."""
_ACCEPTER = regex(r"^[ \t]*accepter:[ \t]*(?P<where>(?:telnet\([^)\n]*\),|telnet,)?tcp,\d+)[ \t\r]*$", re.M)
_FLASK = regex(r"\b(?:app|application|server|socketio)\.run\((?P<arguments>[^()]{0,300})\)")
_ANY_HOST = regex(r"\bhost[ \t]*=[ \t]*[\"'](?:0\.0\.0\.0|::)[\"']")
_DEBUG = regex(r"\bdebug[ \t]*=[ \t]*True\b")
_LISTENER = regex(r"^[ \t]*listener[ \t]+(?P<port>\d+)(?:[ \t]+(?P<address>\S+))?[ \t\r]*$", re.M)
_ANONYMOUS = regex(r"^[ \t]*allow_anonymous[ \t]+(?P<value>true|false)\b", re.M)
_APART = regex(r"^[ \t]*per_listener_settings[ \t]+true\b", re.M)
"""Each listener has settings of its own; else the last one is for all."""
_LIMITED = regex(r"^[ \t]*(?:acl_file|plugin|auth_plugin|bind_interface|require_certificate[ \t]+true)\b", re.M)
_HTTP = regex(r"^\[inet_http_server\][^\n]*(?P<settings>(?:\n(?!\[)[^\n]*)*)", re.M)
_HTTP_PORT = regex(r"^port[ \t]*[=:][ \t]*(?P<where>(?:(?P<address>[^\s:;]*):)?(?P<port>\d+))(?![^\s;])", re.M)
_HTTP_LOGIN = regex(r"^(?:username|password)[ \t]*[=:]", re.M)


class OpenService(NamedTuple):
    kind: str
    """``bridge``, ``shell`` (of Jupyter and terminals), ``desktop``, ``broker``, ``database``, ``flows`` (of Node-RED),
    ``serial``, ``programs`` (of supervisord), ``web`` or ``debugger``."""
    name: str
    where: Span
    default: Span | None = None
    """Where a setting of the program has the address as its default."""


def open_services(files: Files, runners: Runners, launch: Callable[[], Launch]) -> Iterator[OpenService]:
    """The open services of the robot itself; those for development, simulation and tests are left out."""
    if files.of_kind(*LAUNCH):
        from bringup_lint.graph.host.launched_bridges import launched_bridges

        yield from (OpenService("bridge", *each) for each in launched_bridges(files, launch()))
    yield from _serial_ports(files)
    yield from _debuggers(files)
    yield from _supervisors(files)
    named = Counter(_place(runner.service) for runner in runners.all if runner.service is not None)
    for runner in runners.all:
        if runner.purpose is Purpose.ROBOT and runner.source.judged:
            yield from _image(files, runner, named)
            for command in runner.commands:
                yield from _command(command.words)
            for start in runner.starts:
                if str(start.ros.package) in BRIDGES and not _is_limited(start):
                    yield OpenService("bridge", str(start.ros.package), start.ros.where.span)
    for source in files.of_kind("mosquitto"):
        if source.judged and files.purpose(source) is Purpose.ROBOT:
            yield from _broker(source)


def _is_limited(start: Start) -> bool:
    """Whether an argument of ``ros2 launch`` may limit who reaches a bridge, or what for."""
    from bringup_lint.graph.host.launched_bridges import LIMITS

    limits = LIMITS[str(start.ros.package)]
    words = start.step.command.words
    if any(word == "--address" and not is_wildcard(value) for word, value in pairwise(words)):
        return True
    return any(
        name in limits or (name == "address" and value and not is_wildcard(value)) for name, value in start.arguments
    )


def _place(service: Service) -> tuple[str, str]:
    """The folder and the name: compose may put together what several files of a folder say of a service."""
    return os.path.dirname(service.source.absolute), str(service.name)


def _image(files: Files, runner: Runner, named: Counter[tuple[str, str]]) -> Iterator[OpenService]:
    if runner.service is not None and named[_place(runner.service)] == 1:
        from bringup_lint.graph.host.open_images import is_reached
        from bringup_lint.graph.host.open_images import open_image

        yield from (OpenService(*each) for each in open_image(files, runner.service))
        if is_reached(runner.service):
            yield from (found for command in runner.commands for found in _terminal(command.words))


def _serial_ports(files: Files) -> Iterator[OpenService]:
    """What ser2net hands to the network: a port without an address is that of all interfaces."""
    for name in ("ser2net.yaml", "ser2net.yml"):
        for path in files.tree.named(name):
            source = files.tree.at(path)
            if source is None or not source.judged or files.purpose(source) is not Purpose.ROBOT:
                continue
            for accepter in _ACCEPTER.finditer(source.text):
                yield OpenService("serial", "ser2net", source.span(*accepter.span("where")))


def _supervisors(files: Files) -> Iterator[OpenService]:
    """The web server of supervisord, where its section names no user, and a container hands it to the network."""
    for source in files.of_kind("supervisord"):
        if source.template or not source.judged or files.purpose(source) is not Purpose.ROBOT:
            continue
        for section in _HTTP.finditer(source.text):
            port = _HTTP_PORT.search(section["settings"])
            if port is None or _HTTP_LOGIN.search(section["settings"]):
                continue
            address = port["address"] or ""
            if address in ("", "*") or is_wildcard(address):
                begin = section.start("settings")
                where = source.span(begin + port.start("where"), begin + port.end("where"))
                if _leaves_container(files, source, port["port"]):
                    yield OpenService("programs", "supervisord", where)


def _leaves_container(files: Files, source: Source, port: str) -> bool:
    """Whether supervisord runs on the robot itself, or in a container whose port others reach."""
    images = files.of_kind("dockerfile")
    if not any(source.basename in each.text for each in images if files.same_robot(source, each)):
        return True
    reached = re.compile(
        rf"network_mode:[ \t]*[\"']?host|--net(?:work)?[= ]host|(?<![\d.:]){re.escape(port)}:{re.escape(port)}\b"
    )
    starting = files.of_kind("compose", "shell-script", "systemd-unit")
    return any(reached.search(each.text) for each in starting if files.same_robot(source, each))


def _debuggers(files: Files) -> Iterator[OpenService]:
    for source in modules(files):
        if "flask" in source.text and files.purpose(source) is Purpose.ROBOT:
            for call in _FLASK.finditer(source.text):
                arguments = call["arguments"]
                if _ANY_HOST.search(arguments) and _DEBUG.search(arguments):
                    yield OpenService("debugger", "Flask", source.span(*call.span("arguments")))


def _command(words: tuple[Located, ...]) -> Iterator[OpenService]:
    found = open_access(words)
    if found is not None and found.offer is Offer.DESKTOP:
        yield OpenService("desktop", found.program, found.word.span)
    elif found is not None and found.offer is Offer.NOTEBOOK:
        yield OpenService("shell", "Jupyter", found.word.span)


def _terminal(words: tuple[Located, ...]) -> Iterator[OpenService]:
    """A shell in the browser that takes what is typed: since 1.7.4 ttyd only shows it without ``--writable``."""
    found = open_access(words)
    if found is None or found.offer is not Offer.TERMINAL:
        return
    if found.program != "ttyd" or any(word in ("-W", "--writable") for word in words):
        yield OpenService("shell", found.program, found.word.span)


def _broker(source: Source) -> Iterator[OpenService]:
    """A listener on all addresses; without any, mosquitto 2 listens on the loopback interface alone."""
    if _LIMITED.search(source.text):
        return
    listeners = [each for each in _LISTENER.finditer(source.text) if each["port"] != "0"]
    apart = _APART.search(source.text) is not None
    for listener, following in zip(listeners, [*listeners[1:], None]):
        end = following.start() if following is not None and apart else len(source.text)
        said = list(_ANONYMOUS.finditer(source.text, listener.start() if apart else 0, end))
        if not said or said[-1]["value"] != "true":
            continue
        if listener["address"] is None or is_wildcard(listener["address"]):
            first = next(each for each in said if each["value"] == "true")
            yield OpenService("broker", "mosquitto", source.span(first.start(), first.end()))
            return
