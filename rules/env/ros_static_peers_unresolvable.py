"""The robot cannot resolve the name of a static peer.

## What it finds
In a root file system with an `/etc/hosts`: a host name in `ROS_STATIC_PEERS` without a domain (`.local`, `.lan`)
that is neither in that file nor in `/etc/hostname`. In every tree: a peer of more than 255 characters.

## Why it matters on a robot
Fast DDS resolves every peer when a node is created. If one peer cannot be resolved, no node starts. A robot boots
before the network's name server answers, if there is one at all.

## Bad
```sh
ROS_STATIC_PEERS=base-station
```

## Good
```sh
ROS_STATIC_PEERS=10.0.0.20
```

## When to ignore it
When a name server on the robot itself resolves the name, or when the services start only after the network's name
server answers.

## References
- rmw_fastrtps, tried with the real Fast DDS 2.14: `Unable to resolve peer`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.addresses import hosts_in

NAME = regex(r"[A-Za-z][A-Za-z0-9-]*")


@rule("warning", confidence="medium", symptoms=["Unable to resolve peer"])
def ros_static_peers_unresolvable(robot: Robot) -> Iterator[Finding]:
    hosts = robot.tree.find("/etc/hosts") if robot.tree.complete else None
    for setting in robot.ros.of("ROS_STATIC_PEERS"):
        if setting.value != setting.text or re.search(r"[\s,]", setting.text):
            continue
        for peer in hosts_in(setting.value):
            if len(peer) > 255:
                yield finding(
                    peer,
                    f"A peer of {len(peer)} characters is longer than 255: rmw rejects the whole list",
                    advice="write addresses, separated by ';'",
                )
            elif hosts is not None and NAME.fullmatch(peer) and peer.lower() not in _known(robot, hosts):
                yield finding(
                    peer,
                    f"Nothing on the robot gives the address of '{peer}': if it cannot be resolved, no node starts",
                    advice="write the address, or add the name to /etc/hosts",
                    related=[note(hosts, "does not contain it")],
                )


def _known(robot: Robot, hosts: Source) -> set[str]:
    """The names that the robot itself can look up."""
    own = robot.tree.find("/etc/hostname")
    lines = (line.partition("#")[0].split()[1:] for line in hosts.text.splitlines())
    names = {name.lower() for line in lines for name in line} | {"localhost"}
    return names | ({own.text.strip().lower()} if own else set())
