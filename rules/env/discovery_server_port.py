"""The port of the discovery server is not the one that it is started with.

## What it finds
A `ROS_DISCOVERY_SERVER` of which no server has a port on which a command of the tree starts one with
`fastdds discovery` or `fast-discovery-server`. Without a port, 11811 is meant on both sides. Silent where the tree
starts no server, or one by an XML file or with a port that is not known.

## Why it matters on a robot
The clients ask at a port where nobody listens, and they do not fall back to multicast: no node discovers another, and
nothing is logged.

## Bad
```sh
fastdds discovery --server-id 0 --udp-port 11811
export ROS_DISCOVERY_SERVER=10.0.0.10:11888
```

## Good
```sh
fastdds discovery --server-id 0 --udp-port 11811
export ROS_DISCOVERY_SERVER=10.0.0.10:11811
```

## When to ignore it
When these clients belong to another server, which is started outside of the tree.

## References
- Fast DDS documentation, "CLI discovery", "ROS_DISCOVERY_SERVER"
"""

import re
from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

STARTS = regex(
    r"\bfastdds[\"',\s]{1,9}discovery\b[\"',]?(?P<options>[^\n#;&|]{0,400})"
    r"|\bfast-discovery-server(?:-[\d.]+)?\b[\"',]?(?P<more>[^\n#;&|]{0,400})"
)
PORT = regex(r"(?<!\S)[\"']?-(?:p|-udp-port|-port)[\"',=\s]{1,9}(?P<port>[^\s\"',\]]+)")
UNKNOWN = regex(r"[${]|\\\s*$|-x\b|--xml-file|-t\b|--tcp|\bstop\b|\blist\b|-h\b")
STARTED = regex(r"(?<!\S)[\"']?-(?:[ilp]|-server-id|-ip-address|-udp-address|-udp-port|-port)\b")
NO_START = regex(r"#|\b(?:p?grep|p?kill|killall|pidof|echo)\b")
"""The command is only looked for or spoken of."""
BY_FILE = regex(r"discoveryProtocol>\s*(?:SERVER|BACKUP)\s*<")
ADDRESS = regex(r"[\w.-]+(?::(?P<port>\d+))?")
KINDS = ("shell-script", "systemd-unit", "systemd-dropin", "compose", "dockerfile", "launch-python", "launch-xml")
LISTENS = regex(r"(?<!\S)[\"']?-(?:l|-listening-address|-udp-address)[\"',=\s]{1,9}(?P<address>[\d.]{7,15})")
LOCAL = ("127.0.0.1", "localhost", "0.0.0.0")
DEFAULT = "11811"
LINE = 400
"""Characters before a command that may say what it is for."""
MOST = 10
"""Servers that a message names."""


@rule("warning", confidence="medium", silent="clients of a discovery server wait for it forever")
def discovery_server_port(robot: Robot) -> Iterator[Finding]:
    settings = [each.value for each in robot.ros.of("ROS_DISCOVERY_SERVER")]
    if not settings or robot.mentions(BY_FILE):
        return
    servers = dict(_servers(robot))
    if not servers or None in servers:
        return
    seen = set()
    for value in settings:
        ports = _ports(value)
        if not ports or not ports.isdisjoint(servers) or value.span in seen or _is_elsewhere(robot, value, ports):
            continue
        seen.add(value.span)
        yield finding(
            value,
            f"The server listens on port {', '.join(map(str, servers))}, and not on {', '.join(sorted(ports))}: no node"
            " discovers another",
            advice="write the same port on both sides",
            related=[note(where, "started here") for where in islice(servers.values(), MOST)],
        )


def _servers(robot: Robot) -> Iterator[tuple[str | None, Located]]:
    """The ports of the servers that the tree starts, None for one that is not known."""
    for source in robot.of_kind(*KINDS):
        if "discovery" not in source.text:
            continue
        for match in STARTS.finditer(source.text):
            line = source.line_before(match.start())[-LINE:]
            options = match["options"] or match["more"] or ""
            if NO_START.search(line) or not (STARTED.search(options) or options.endswith("\\")) or not source.judged:
                continue
            where = source.located(match.start(), match.end())
            is_cut = line.count("[") > (line + match[0]).count("]")
            ports = [each["port"] for each in PORT.finditer(options)]
            known = not is_cut and not UNKNOWN.search(options) and all(port.isdigit() for port in ports)
            yield from ((port, where) for port in (ports or [DEFAULT])) if known else ((None, where),)


def _is_elsewhere(robot: Robot, value: str, ports: set[str]) -> bool:
    """Whether another server may be meant: one that listens at another address, or by a port that Docker maps."""
    mapped = re.compile(rf"\b(?:{'|'.join(map(re.escape, ports))}):\d+")
    if any(mapped.search(each.text) for each in robot.of_kind("compose")):
        return True
    listening = {match["address"] for each in robot.of_kind(*KINDS) for match in LISTENS.finditer(each.text)}
    own = (*LOCAL, *listening)
    return bool(listening.difference(LOCAL)) and not any(address in value for address in own)


def _ports(value: str) -> set[str]:
    """The ports of the servers in a value; none where one of them is not known."""
    servers = [each.strip() for each in value.strip("\"'").split(";") if each.strip()]
    matches = [ADDRESS.fullmatch(each) for each in servers]
    if any(match is None for match in matches):
        return set()
    return {match["port"] or DEFAULT for match in matches if match is not None}
