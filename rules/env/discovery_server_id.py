"""Clients look for a discovery server of another number.

## What it finds
A list of servers, in `ROS_DISCOVERY_SERVER` or the `discoveryServersList` of a Fast DDS file, where no server has the
number with which a command of the tree starts one (`fastdds discovery -i N`), and one of them has its port. In
the variable, the place in the list is the number, so that `;10.0.0.5:11811` is server 1. In a file, the third byte of
the prefix `44.53.00.5f.45.50.52.4f.53.49.4d.41` is.

A unit, a script, a service or a Dockerfile that starts a server without a number (`-i`) and without a file (`-x`),
which Fast DDS 2 refuses, is an error.

Silent where the number of a server is not known, and from Kilted on: Fast DDS 3 does not compare the prefixes.

## Why it matters on a robot
The client reaches the server, and does not take its answers, because they come from another prefix. No node discovers
another, and nothing is logged. A server without a number ends at once.

## Bad
```sh
fastdds discovery -i 1 -l 10.0.0.5 -p 11811
export ROS_DISCOVERY_SERVER=10.0.0.5:11811
```

## Good
```sh
fastdds discovery -i 1 -l 10.0.0.5 -p 11811
export ROS_DISCOVERY_SERVER=";10.0.0.5:11811"
```

## When to ignore it
When these clients belong to another server, which is started outside of the tree.

## References
- Fast DDS 2.6 and 2.14, `tools/fds/server.cpp`: "Server id is mandatory if not defined in the XML file"
- Fast DDS 2.14 documentation, "ROS_DISCOVERY_SERVER" and "CLI discovery", `--server-id`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import at_least
from bringup_lint.api.xml import Element

STARTS = regex(
    r"\b(?:fastdds[\"',\s]{1,9}discovery|fast-discovery-server(?:-[\d.]+)?)\b[\"',]?"
    r"(?P<options>(?:[^\n#;&|\\]|\\\r?\n){0,400})",
    hints="discovery",
)
NUMBER = regex(r"(?<!\S)[\"']?-(?:i|-server-id)[\"',=\s]{1,9}(?P<number>[^\s\"',\]]+)")
PORT = regex(r"(?<!\S)[\"']?-(?:p|-udp-port|-port)[\"',=\s]{1,9}(?P<port>[^\s\"',\]]+)")
BY_FILE = regex(r"(?<!\S)[\"']?-(?:x|-xml-file)\b")
NO_START = regex(r"#|\b(?:p?grep|p?kill|killall|pidof|echo)\b")
"""The command is only looked for or spoken of."""
LOCAL = regex(r"(?<!\S)-(?:l|-udp-address|-listening-address|p|-udp-port|-port)\b")
NUMBERED = regex(r"(?<!\S)-(?:\w*i|-server-id|x|-xml-file|h|-help|e|-example|v|-version)\b|[$%{@]")
"""A number or a file, what needs neither, and what may stand for them."""
LAUNCH = ("launch-python", "launch-xml")
"""Their words may be in lists."""
KINDS = ("shell-script", "systemd-unit", "systemd-dropin", "compose", "dockerfile", "launch-python", "launch-xml")
PREFIX = regex(r"44\.53\.(?P<number>[0-9a-fA-F]{2})\.5f\.45\.50\.52\.4f\.53\.49\.4d\.41", hints="44.53")
ADDRESS = regex(r"(?:[\w.-]+|\[[0-9a-fA-F:]+\])(?::(?P<port>\d+))?")
DEFAULT = "11811"
LINE = 400
"""Characters before a command that may say what it is for."""


class Server(NamedTuple):
    number: int
    port: str
    where: Located


@rule("warning", confidence="medium", symptoms=["Server id is mandatory if not defined in the XML file"])
def discovery_server_id(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(STARTS):
        return
    if at_least(robot.target.ros, "humble") is not True or at_least(robot.target.ros, "kilted") is not False:
        return
    yield from _unnumbered(robot)
    started = list(_started(robot))
    known = [each for each in started if each is not None]
    if not known or len(known) < len(started):
        return
    lists = list(_of_variables(robot))
    if robot.of_kind("fastdds"):
        lists += [_of_list(each) for each in _lists(robot)]
    for asked in lists:
        numbers = {each.number for each in known}
        first = next((one for one in known if any(one.port == other.port for other in asked)), None)
        if first is not None and numbers.isdisjoint(each.number for each in asked):
            meant = next(each for each in asked if each.port == first.port)
            yield finding(
                meant.where,
                f"This asks for server {meant.number}, and server {first.number} is started: no node discovers another",
                advice="start the server with this number, or ask for that one",
                related=[note(first.where, "started here")],
            )


def _commands(robot: Robot) -> Iterator[tuple[Source, re.Match[str]]]:
    """The commands of the tree that start a server."""
    for source in robot.of_kind(*KINDS):
        if source.judged and "discovery" in source.text:
            for match in STARTS.finditer(source.text):
                if match["options"].strip() and not NO_START.search(source.line_before(match.start())[-LINE:]):
                    yield source, match


def _unnumbered(robot: Robot) -> Iterator[Finding]:
    """Those that Fast DDS 2 refuses: any other options may come out of a variable, or be of another line."""
    for source, match in _commands(robot):
        options = match["options"]
        if LOCAL.search(options) and not NUMBERED.search(options) and source.kind not in LAUNCH:
            yield finding(
                source.located(match.start(), match.start("options")),
                "The server gets no number (-i) and no file (-x): it ends at once, and no node discovers another",
                advice="add -i 0",
                severity="error",
            )


def _started(robot: Robot) -> Iterator[Server | None]:
    """The servers that commands of the tree start; None for one whose number or port is not known."""
    for source, match in _commands(robot):
        options = match["options"]
        number, port = NUMBER.search(options), PORT.search(options)
        value = port["port"] if port else DEFAULT
        if number is None or not number["number"].isdecimal() or BY_FILE.search(options) or not value.isdecimal():
            yield None
        else:
            begin = match.start("options") + number.start("number")
            where = source.located(begin, begin + len(number["number"]))
            yield Server(int(number["number"]), value, where)


def _of_variables(robot: Robot) -> Iterator[list[Server]]:
    seen = set()
    for setting in robot.ros.of("ROS_DISCOVERY_SERVER"):
        value = setting.value
        parts = value.strip("\"'").split(";")
        matches = [ADDRESS.fullmatch(part.strip()) for part in parts]
        if value.span in seen or any(match is None and part.strip() for match, part in zip(matches, parts)):
            continue
        seen.add(value.span)
        yield [Server(at, match["port"] or DEFAULT, value) for at, match in enumerate(matches) if match is not None]


def _lists(robot: Robot) -> Iterator[Element]:
    files = (each for each in robot.dds.profile_files if each.source.judged)
    elements = (each for file in files for one in file.default_participants for each in one.walk())
    return (each for each in elements if each.local == "discoveryServersList")


def _of_list(servers: Element) -> list[Server]:
    found = (_of_element(each) for each in servers.find_all("RemoteServer"))
    return [each for each in found if each is not None]


def _of_element(server: Element) -> Server | None:
    prefix = server.get("prefix")
    match = PREFIX.fullmatch(prefix) if prefix is not None else None
    port = next((each.text for each in server.walk() if each.local in ("port", "physical_port")), None)
    return Server(int(match["number"], 16), str(port), prefix) if prefix and match and port else None
