"""A node runs that the files do not start.

## What it finds
Running nodes that no launch file, unit or compose service of the tree names. Hidden nodes, tools (rviz, rqt,
rosbag, the daemon of ros2cli), nodes of libraries and nodes that a known node brings along do not count. Silent
as soon as the files leave the name of a node open: then it may be that one.

## Why it matters on a robot
A left-over of yesterday's test, a second robot or a colleague's laptop in the same domain publishes, and the
robot obeys it as well.

## Bad
```yaml
nodes:
- {name: /lidar/driver, enclave: /}
- {name: /teleop_test, enclave: /}
```

## Good
```yaml
nodes:
- {name: /lidar/driver, enclave: /}
```

## References
- ROS 2 documentation, "The ROS_DOMAIN_ID"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium")
def node_unexpected(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    if observed.expected.gaps or not observed.expected.nodes:
        return
    missing = [node for nodes in observed.missing.values() for node in nodes]
    told = {str(other.name) for node in missing if (other := observed.namesake(node.name))}
    for node in {str(node.name): node for node in observed.nodes}.values():
        if node.name in told or observed.accounts_for(node):
            continue
        same = [each for each in observed.expected.nodes if each.name.rpartition("/")[2] == node.bare]
        yield finding(
            node.name,
            f"{node.name} runs on domain {observed.graph.domain}, and no file starts it",
            advice="find out who started it; if it belongs to the robot, start it from a launch file",
            related=[note(each.where, f"this one is {each.name}") for each in same[:1]],
        )
