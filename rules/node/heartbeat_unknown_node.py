"""A watchdog monitors a node that does not exist.

## What it finds
Names in a list of monitored nodes (`monitored_nodes`, `required_nodes`, `nodes_to_watch`, ...) in Python sources
and parameter files, and names that a script looks for with `ros2 node list | grep`, when no node that the tree
starts has that name. Reported only where all launch files and all their nodes are known by name.

## Why it matters on a robot
A watchdog that misses a node stops the robot forever, or an annoyed operator switches it off. A watchdog with the
wrong name never notices that the right node died. A script that waits for the name runs into its timeout at every
boot.

## Bad
```yaml
monitored_nodes: [lidar_driver, base]   # the node is called lidar
```

## Good
```yaml
monitored_nodes: [lidar, base]
```

## When to ignore it
When the node runs on another computer, or is started by hand.

## References
- ROS 2 documentation, "Understanding nodes", remapping of node names
- grep(1): a pattern matches anywhere in a line, without `-x`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


def is_alone(name: Located) -> bool:
    """Whether the file has this name nowhere else, where it would stay wrong."""
    return "/" not in name and name.span.source.text.count(name) == 1


@rule("warning", fix="unsafe", silent="a topic without a publisher is normal for ROS")
def heartbeat_unknown_node(robot: Robot) -> Iterator[Finding]:
    for name, watched, meant, is_typo in robot.topics.missing_nodes:
        node = next((each for each in robot.topics.named_nodes if each.name == meant), None)
        what = f"the node is '{meant}'" if meant else "nothing in the tree starts it"
        better = (
            f"call it '{meant}' on both sides" if meant else "name a node that is started, as `ros2 node list` shows it"
        )
        yield finding(
            name,
            f"No node is called '{name}' ({what}): a watchdog or script that waits for it never sees it",
            advice=better,
            related=[
                *([note(watched.where, "this list monitors it")] if watched.where is not name else []),
                *([note(node.started.span, f"{node.label()} is started here")] if node else []),
            ],
            fix=fix(f"write '{meant}'", (name, meant), safe=False) if meant and is_typo and is_alone(name) else None,
        )
