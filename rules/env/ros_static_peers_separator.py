"""The peers in ROS_STATIC_PEERS are not separated by semicolons.

## What it finds
A comma or a space in ROS_STATIC_PEERS, also at an end or next to a semicolon. A semicolon at the end is valid.

## Why it matters on a robot
Everything between two semicolons, including spaces and commas, is one host name. Fast DDS cannot resolve it and
refuses to create the node.

## Bad
```sh
ROS_STATIC_PEERS=10.0.0.1,10.0.0.2
```

## Good
```sh
ROS_STATIC_PEERS=10.0.0.1;10.0.0.2
```

## When to ignore it
Never: no host name contains spaces or commas.

## References
- rcl, `discovery_options.c`: peers are separated by `;`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule

QUOTES = ("'", '"')
NO_SHELL = regex(r"\s*(?:Environment=|- *['\"]?ROS_STATIC_PEERS=|['\"]?ROS_STATIC_PEERS['\"]?\s*:)")
"""How a line begins whose value no shell reads: in a unit, or in a list or mapping of YAML."""


@rule("error", fix="safe", symptoms=["Unable to resolve peer"])
def ros_static_peers_separator(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_STATIC_PEERS"):
        peers = [peer for peer in re.split(r"[,;\s]+", setting.text) if peer]
        if peers and re.search(r"[,\s]", setting.text):
            right = ";".join(peers)
            as_written = setting.value == setting.text
            yield finding(
                setting.value,
                f"'{setting.text}' has spaces or commas, which become part of a host name: with Fast DDS no node "
                "starts",
                advice=f"write {right}",
                fix=fix("separate the peers by ';'", (setting.value, right))
                if as_written and not _ends_command(robot, setting.value)
                else None,
            )


def _ends_command(robot: Robot, value: Located) -> bool:
    """Whether a shell may read the value without quotes, so that a ';' in it ends the command."""
    span = value.span
    text = span.source.text
    if text[span.start - 1 : span.start] in QUOTES and text[span.end : span.end + 1] in QUOTES:
        return False
    if any(file.source is span.source and file.sourced_by is None for file in robot.env_files):
        return False
    return NO_SHELL.match(span.source.line_text(span.line)) is None
