"""A watchdog that waits for a node that does not exist.

## What it finds
Names in a list of watched nodes (`monitored_nodes`, `required_nodes`, `nodes_to_watch`, ...), in Python sources and
parameter files, and names that a script looks for with `ros2 node list | grep`, that no node has which the tree starts.
Only where all launch files and all their nodes are known by name.

## Why it matters on a robot
A watchdog that misses a node stops the robot forever, or is switched off by the first annoyed operator. One that looks
for the wrong name never notices that the right one died. A script that waits for it ends in its timeout at every boot.

## Bad
```yaml
monitored_nodes: [lidar_driver, base]   # the node is called lidar
```

## Good
```yaml
monitored_nodes: [lidar, base]
```

## References
- ROS 2 documentation, "Understanding nodes", remapping of node names
- grep(1): a pattern matches anywhere in a line, without `-x`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="unsafe")
def heartbeat_unknown_node(robot: Robot) -> Iterator[Finding]:
    for name, watched, meant in robot.topics.missing_nodes:
        node = next((each for each in robot.topics.named_nodes if each.name == meant), None)
        what = f"the node is '{meant}'" if meant else "nothing in the tree starts it"
        yield finding(
            name,
            f"No node is called '{name}', {what}: what waits for it never sees it",
            advice=f"write '{meant}'" if meant else "name a node that is started, as `ros2 node list` shows it",
            related=[
                *([note(watched.where, "it is watched by this list")] if watched.where is not name else []),
                *([note(node.started.span, f"{node.label()} is started here")] if node else []),
            ],
            fix=fix(f"write '{meant}'", (name, meant), safe=False) if meant and "/" not in name else None,
        )
