"""The firewall does not open the port of a bridge.

## What it finds
A script that enables ufw, opens single ports, and not 9090 or 8765, while the robot starts rosbridge (9090) or
foxglove_bridge (8765) on the computer itself with its default port.

Silent where a whole subnet or interface is let in, where a file of the tree forwards to the port (a web server or a
tunnel), and for containers, whose published ports Docker opens itself.

## Why it matters on a robot
The bridge runs, its log shows no error, and every connection from the operator's computer times out.

## Bad
```sh
# the robot starts foxglove_bridge
ufw allow ssh
ufw --force enable
```

## Good
```sh
ufw allow ssh
ufw allow from 192.168.4.0/24 to any port 8765 proto tcp
ufw --force enable
```

## When to ignore it
When only programs on the robot use the bridge.

## References
- ufw(8): incoming packets are denied by default
- https://github.com/RobotWebTools/rosbridge_suite, https://github.com/foxglove/ros-foxglove-bridge
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

FORWARDED = (
    r"(?:localhost|127\.0\.0\.1|proxy_pass|ProxyPass|-L|-R)[^\s:]{0,80}[ \t]?[^\s:]{0,80}(?::[^\s:]{0,80}){0,3}:"
)
PORTS = {
    "rosbridge_server": (9090, regex(rf"{FORWARDED}9090\b")),
    "foxglove_bridge": (8765, regex(rf"{FORWARDED}8765\b")),
}
"""The default port of each, and how another program of the computer hands connections on to it."""

FIREWALL = regex(r"\b(?:ufw|iptables|nft|firewalld|firewall-cmd)\b")
REACHED = regex(r"\btailscale\b|DEFAULT_INPUT_POLICY")
"""Tailscale lets in what comes through it; the policy of ufw may be another one."""


@rule(
    "warning",
    confidence="medium",
    symptoms=["[UFW BLOCK] * PROTO=TCP * DPT=9090", "[UFW BLOCK] * PROTO=TCP * DPT=8765"],
)
def bridge_port(robot: Robot) -> Iterator[Finding]:
    closed = [each for each in robot.firewalls if each.is_closed_ufw]
    if not closed:
        return
    bridges = {each.name: each.where for each in robot.open_services if each.kind == "bridge" and _is_usual(each.where)}
    for firewall in closed:
        for name, where in bridges.items():
            port, forwarded = PORTS[name]
            if firewall.opens(port) or not robot.same_robot(firewall.source, where.source):
                continue
            near = (each for each in robot.sources if robot.same_robot(each, where.source))
            if any(_lets_in(each, firewall.source, port, forwarded) for each in near):
                continue
            yield finding(
                firewall.tools["ufw"],
                f"ufw does not let in port {port}: nobody outside reaches {name}",
                advice=f"add: ufw allow {port}/tcp",
                related=[note(where, "starts it")],
            )


def _lets_in(source: Source, script: Source, port: int, forwarded: re.Pattern[str]) -> bool:
    """Whether a file hands connections on to the port, or one beside the script may open it."""
    text = source.text
    if REACHED.search(text):
        return True
    may_open = source is not script and str(port) in text and FIREWALL.search(text) is not None
    return may_open or forwarded.search(text) is not None


def _is_usual(where: Span) -> bool:
    """Whether a bridge runs on the computer itself, with its default port."""
    text = where.source.text
    line = text[text.rfind("\n", 0, where.start) + 1 : max(where.end, text.find("\n", where.end))]
    return "port" not in line.replace("import", "") and where.source.kind not in ("compose", "dockerfile")
