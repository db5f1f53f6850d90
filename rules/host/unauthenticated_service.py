"""A service lets everybody on the network control the robot.

## What it finds
Services of the robot itself that listen on all addresses and ask for no password:
- **error**: Jupyter with an empty token on `--ip=0.0.0.0`, in a compose service also `ttyd --writable` without
  `--credential` and `code-server --auth none`, a VNC server with `SecurityTypes None` or `-nopw`, a compose service
  whose image serves a desktop or an editor without a password (`linuxserver/baseimage-kasmvnc`, `linuxserver/webtop`,
  `linuxserver/code-server`, `theasp/novnc`), and Flask with `debug=True` on `0.0.0.0`: its debugger runs Python for
  whoever knows or guesses the PIN, and its reloader runs the program, and so a node in it, twice. With an option by
  which the program makes people acknowledge that (`--I-KNOW-THIS-IS-INSECURE`), a warning.
- **warning**: `rosbridge_server` and `foxglove_bridge`, which publish for their clients, in a tree that mentions
  `cmd_vel` outside of a simulation and of lists of what is recorded, or has a node with a `Twist` of such a name;
  information in others. A mosquitto broker with `allow_anonymous true`, a ser2net `accepter: tcp,PORT` without an
  address, and the `[inet_http_server]` of supervisord on all addresses without a user. A compose service with the image
  of a database (`mongo`, `redis`, `valkey`, `memcached`, `influxdb:1`, `elasticsearch:7`; `postgres`, `mysql` and later
  ones of `elasticsearch` where a variable takes the password away), of Node-RED, mosquitto 1 or EMQX that is on the
  host network or publishes its port, and sets no password. A server (Flask, uvicorn, websockets, aiohttp, NiceGUI,
  `http.server`, a socket and others) on all addresses in a node that publishes velocities, goals or other commands, and
  has no login. The address may be the default of a parameter, an option or a variable that nothing in the tree sets.

Not reported: a service on the loopback address, with a password, with limits of its own (`topics_glob`,
`capabilities` without `clientPublish`, `acl_file`), with parameters that are not known, and services for simulation,
development and tests.

## Why it matters on a robot
Whoever joins the robot's network opens a web page and drives it, or runs programs with the rights of the service.
Neither ROS_DOMAIN_ID nor SROS2 keeps them out: the bridge itself is a trusted participant.

## Bad
```ini
ExecStart=/usr/bin/x0vncserver -display :0 -SecurityTypes=None
```

## Good
```ini
ExecStart=/usr/bin/x0vncserver -display :0 -rfbauth /etc/rover/vncpasswd -localhost
```

## When to ignore it
If only trusted machines are on the network of the robot, or a firewall or a proxy with a login protects the port.

## References
- rosbridge_server: parameter `address`; foxglove_bridge: parameters `address` and `capabilities`
- Jupyter Server, "Running a public Jupyter server"; Xvnc(1), SecurityTypes; mosquitto.conf(5), allow_anonymous
- https://hub.docker.com/_/redis, "Security"; https://hub.docker.com/_/mongo, "Authentication"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import docker
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service

WARNED = ("broker", "web", "serial", "database", "flows", "programs")
DRIVES = regex(r"cmd_vel")
COMMANDS = regex(r"cmd_vel(?!oc)")
TWIST = regex(r"\bTwist(?:Stamped)?\b")
RECORDS = regex(r"record|rosbag|(?:^|/)bags?/|(?:^|[/_-])bags?[_.-][^/]*$", re.I)
"""Files that name topics only to keep what is published there."""
TEXTS = {
    "shell": ("runs programs of everybody who reaches its port", "set a password, or listen on 127.0.0.1"),
    "desktop": ("gives the desktop to everybody who reaches its port", "set a password, or add -localhost"),
    "bridge": (
        "publishes and calls services for everybody who reaches its port",
        "set the parameter address to 127.0.0.1, limit what clients may publish, or close the port in the firewall",
    ),
    "debugger": (
        "runs with its debugger for everybody who reaches its port",
        "remove debug=True, and listen on 127.0.0.1",
    ),
    "web": (
        "drives the robot for everybody who reaches its port",
        "ask for a password, or listen on 127.0.0.1 with a proxy that does",
    ),
    "serial": (
        "hands a serial port to everybody who reaches its port",
        "write the address too, as in 'accepter: tcp,127.0.0.1,2022', or close the port in the firewall",
    ),
    "programs": (
        "lets everybody who reaches its port stop and start its programs",
        "listen on 127.0.0.1, or set username and password",
    ),
    "database": (
        "lets everybody who reaches its port read, change and delete its data",
        "set a password, or publish the port on 127.0.0.1 alone",
    ),
    "flows": (
        "lets everybody who reaches its port change its flows, which run commands",
        "set adminAuth in settings.js, or publish the port on 127.0.0.1 alone",
    ),
    "broker": ("takes messages from everybody who reaches its port", "use password_file, or bind it to 127.0.0.1"),
}

HERE = "publish the port of its container on 127.0.0.1 alone"
IN_CONTAINERS = {
    "shell": f"set a password, or {HERE}",
    "desktop": f"set a password, or {HERE}",
    "bridge": f"limit what clients may publish, or {HERE}",
    "debugger": f"remove debug=True, and {HERE}",
    "web": f"ask for a password, or {HERE}, with a proxy that does",
    "serial": "publish the port of its container on 127.0.0.1, or on the one address of the robot that needs it",
    "programs": f"set username and password, or {HERE}",
    "broker": f"use password_file, or {HERE}",
}
"""What helps where Docker hands the port on: there, 127.0.0.1 is the container, and nothing reaches it."""


@rule(
    "error",
    tags=["CWE-306"],
    symptoms=["All authentication is disabled. Anyone who can connect to this server will be able to run code."],
)
def unauthenticated_service(robot: Robot) -> Iterator[Finding]:
    services: dict[tuple[str, str], list[Span]] = {}
    defaults: dict[Span, Span] = {}
    for each in robot.open_services:
        services.setdefault((each.kind, each.name), []).append(each.where)
        if each.default is not None:
            defaults[each.where] = each.default
    for (kind, name), (first, *others) in services.items():
        does, advice = TEXTS[kind]
        if kind in IN_CONTAINERS and _is_in_network_of_docker(robot, first):
            advice = IN_CONTAINERS[kind]
        motion = kind == "bridge" and _is_driven(robot)
        yield finding(
            first,
            f"{name} asks for no password and {does}" + (", velocities included" if motion else ""),
            advice=advice,
            related=[
                *(note(defaults[each], "the default of its address") for each in (first, *others) if each in defaults),
                *(note(each, "and here") for each in others),
            ],
            severity=_severity(kind, motion) or ("warning" if _is_known_open(first) else None),
            confidence="medium" if kind in WARNED or kind == "bridge" else None,
        )


def _is_in_network_of_docker(robot: Robot, where: Span) -> bool:
    """Whether a service is in containers that are not on the host network."""
    services = docker.services_with(robot.compose, where) if robot.of_kind("compose") else []
    return bool(services) and not any(_is_on_host_network(robot, service) for service in services)


def _is_on_host_network(robot: Robot, service: Service) -> bool:
    """Whether a container is on the host network, by itself or by way of the one whose network it shares."""
    kind, _, name = str(service.network_mode or "").partition(":")
    shared = [each for each in robot.compose.services if name and name in (each.name, each.scalar("container_name"))]
    return service.is_on_host_network or (
        kind in ("service", "container") and (not shared or any(each.is_on_host_network for each in shared))
    )


def _is_driven(robot: Robot) -> bool:
    """Whether a file names the topic that drives the robot, and not one that a simulator drives."""
    if not robot.mentions(DRIVES):
        return False
    said = (each for each in robot.sources if each.judged and _is_driving(each))
    return any(robot.files.purpose(each).value != "simulation" for each in said)


def _is_driving(source: Source) -> bool:
    """Whether a file names a topic of velocities: a node, whatever the names of the file and the topic, and others
    that do not only record it."""
    if source.kind in ("python-node", "cpp-node") and source.says(TWIST):
        return source.says(DRIVES)
    return source.says(COMMANDS) and not RECORDS.search(source.name)


def _severity(kind: str, motion: bool) -> str | None:
    if kind == "bridge":
        return "warning" if motion else "info"
    return "warning" if kind in WARNED else None


def _is_known_open(where: Span) -> bool:
    """Whether an option of the command says that somebody knows what it does."""
    return "INSECURE" in where.source.line_text(where.line)
