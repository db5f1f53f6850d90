"""Two running nodes have the same name.

## What it finds
Fully qualified names that the running graph shows more than once.

## Why it matters on a robot
Parameters and services reach one of the two by chance, lifecycle managers and monitors see one node, and both
publish. Most often a node was started twice: by a unit and by hand, or by two launch files. A node that was killed
stays visible until its lease ends, up to 20 s with Fast DDS.

## Bad
```yaml
nodes:
- {name: /lidar/driver, enclave: /}
- {name: /lidar/driver, enclave: /}
```

## Good
```yaml
nodes:
- {name: /lidar_front/driver, enclave: /}
- {name: /lidar_rear/driver, enclave: /}
```

## When to ignore it
Never for two processes that both run. A node that was just killed disappears from the next run.

## References
- https://github.com/ros2/launch_ros/issues/124
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Publisher already registered for node name"])
def node_duplicate(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    for nodes in observed.duplicates:
        name = nodes[0].name
        where = observed.place(name)
        starts = [each for each in observed.expected.nodes if each.name == name and each.where != where]
        lines = nodes if where.source is not name.span.source else nodes[1:]
        yield finding(
            where,
            f"{len(nodes)} nodes with the name {name} are running: which of them answers a parameter or service "
            "call is left to chance",
            advice="stop the surplus one; a node that was killed disappears within 20 s",
            related=[
                *(note(each.where, "started here too") for each in starts[:3]),
                *(note(node.name, "this one runs") for node in lines[:5]),
            ],
        )
