"""Parameters for a node that has another name in the robot's distribution.

## What it finds
Blocks for `recoveries_server`, which Navigation2 has called `behavior_server` since Humble, in files without a block
for the new name. The distribution is that of the robot, or the one in the path of the file; where the tree names
several, all of them have the new name. Silent where a launch file or a program has the old name.

## Why it matters on a robot
No message appears: no node of that name starts, and the new one runs with the defaults of its code. The robot turns and
backs up faster or further than it was tuned to, in the frames and with the costmaps of the defaults.

## Bad
```yaml
recoveries_server:
  ros__parameters:
    max_rotational_vel: 0.4
```

## Good
```yaml
behavior_server:
  ros__parameters:
    max_rotational_vel: 0.4
```

## When to ignore it
When the file is kept for a robot with Galactic or older.

## References
- https://docs.nav2.org/migration/Galactic.html, "Recoveries renamed to behaviors"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import renamed_nodes


@rule("warning", silent="the block matches no node")
def node_renamed(robot: Robot) -> Iterator[Finding]:
    for each in renamed_nodes(robot.params):
        now, since = each.renaming
        yield finding(
            each.block.key,
            f"'{each.block.node_name}' is called {now} since {since.capitalize()}: these parameters are never used, "
            "and the defaults stay",
            advice=f"write {now}, and compare its parameters with those of {since.capitalize()}",
            related=[note(other.key, "the same here") for other in each.others],
            severity=None if each.is_used else "info",
        )
