"""ROS_STATIC_PEERS are separated by something else than a semicolon.

## What it finds
A comma or a blank in ROS_STATIC_PEERS, also at an end or beside a semicolon. A semicolon at the end is fine.

## Why it matters on a robot
What stands between two semicolons, blanks and commas included, is taken as one host name. Fast DDS cannot
resolve it and refuses to create the node.

## Bad
```sh
ROS_STATIC_PEERS=10.0.0.1,10.0.0.2
```

## Good
```sh
ROS_STATIC_PEERS=10.0.0.1;10.0.0.2
```

## References
- rcl, `discovery_options.c`: peers are separated by `;`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Unable to resolve peer"])
def ros_static_peers_separator(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_STATIC_PEERS"):
        peers = [peer for peer in re.split(r"[,;\s]+", setting.text) if peer]
        if peers and re.search(r"[,\s]", setting.text):
            right = ";".join(peers)
            as_written = setting.value == setting.text
            yield finding(
                setting.value,
                f"'{setting.text}' has blanks or commas, which become part of a host name: no node starts with Fast "
                "DDS",
                advice=f"write {right}",
                fix=fix("separate the peers by ';'", (setting.value, right)) if as_written else None,
            )
