"""ROS services of one compose file cannot reach each other.

## What it finds
- A ROS service on a bridge network while another ROS service of the same file has `network_mode: host`. Silent if the
  service has a discovery server, static peers, a CYCLONEDDS_URI or Zenoh.
- UDP ports of DDS (7400 and above) that a service on a bridge network publishes. Silent in the same cases.
- `ports:` together with `network_mode: host`, which Docker ignores: a warning where a port is to get another number on
  the host, else an info.

Services whose `profiles` never run together, and a service with domain_bridge, are not compared.

## Why it matters on a robot
Multicast discovery does not leave the bridge: the two halves of the robot never see each other's nodes.

## Bad
```yaml
nav:  {image: ros:jazzy, network_mode: host}
slam: {image: ros:jazzy}
```

## Good
```yaml
nav:  {image: ros:jazzy, network_mode: host}
slam: {image: ros:jazzy, network_mode: host}
```

## When to ignore it
When the service on the bridge only talks to others over HTTP or another protocol, not over ROS topics.

## References
- https://github.com/ros2/ros2/issues/1318
- Docker documentation, host network driver
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Beside
from bringup_lint.api.compose import Service

PUBLISHED = regex(r"(?:[\d.]+:)?(?:\d+(?:-\d+)?:)?(\d+)(?:-\d+)?/udp")
OF_DDS = range(7400, 7700)
"""The ports of the first domains (DDSI-RTPS, 9.6.2)."""
OTHER_WAYS = ("ROS_DISCOVERY_SERVER", "ROS_STATIC_PEERS", "CYCLONEDDS_URI", "ZENOH_ROUTER_CONFIG_URI")


@rule("warning", symptoms=["Published ports are discarded when using host network mode"])
def bridge_network_ros(robot: Robot) -> Iterator[Finding]:
    for file in robot.compose.files:
        if file.source.template:
            continue
        yield from _apart(robot, [service for service in file.services if service.is_ros and service.is_whole])
        for service in file.services:
            published = _published(service)
            if published is not None and not _finds_others(robot, service):
                yield finding(
                    published,
                    f"'{service.name}' publishes ports of DDS from a bridge network: it announces the address of the "
                    "container, and nodes outside never reach it",
                    advice="use network_mode: host",
                )
            if service.is_on_host_network and service.key("ports") is not None:
                yield finding(
                    service.place_of("ports"),
                    f"'{service.name}' is on the host network: its ports are ignored",
                    advice="remove ports:",
                    related=[note(service.place_of("network_mode"), "the host network")],
                    severity=None if any(_is_changed(port) for port in service.items("ports")) else "info",
                )


def _published(service: Service) -> Located | None:
    """The first port of DDS that a service on a network of its own publishes."""
    if service.network_mode is not None:
        return None
    matches = ((port, PUBLISHED.fullmatch(port)) for port in service.items("ports"))
    return next((port for port, match in matches if match is not None and int(match[1]) in OF_DDS), None)


def _is_changed(port: str) -> bool:
    """Whether a short mapping gives a port another number on the host, which then does not come about."""
    *_, host, inside = ["", *port.partition("/")[0].split(":")][-3:]
    return bool(host) and "$" not in port and host != inside


def _apart(robot: Robot, services: list[Service]) -> Iterator[Finding]:
    host = [service for service in services if service.is_on_host_network]
    known = Beside(host)
    for service in services:
        first = known.first(service)
        if first is None or service.network_mode is not None or _finds_others(robot, service):
            continue
        beside = host[first]
        yield finding(
            service.name,
            f"'{service.name}' is on a bridge network, '{beside.name}' on the host's: they never find each other",
            advice="use network_mode: host in both, or a discovery server",
            related=[note(beside.place_of("network_mode"), f"'{beside.name}' is on the host network")],
        )


def _finds_others(robot: Robot, service: Service) -> bool:
    if len(robot.compose.env_files(service)) < len(service.env_files) or service.restart == "no":
        return True
    if any("domain_bridge" in word for word in service.scripts):
        return True
    rmw = robot.compose.variables(service, "RMW_IMPLEMENTATION")
    return bool(robot.compose.variables(service, *OTHER_WAYS)) or any("zenoh" in value for _, value in rmw)
