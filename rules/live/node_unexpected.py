"""A node is running that the files do not start.

## What it finds
Running nodes that no launch file, unit or compose service of the tree names. Not reported: hidden nodes, tools
(rviz, rqt, rosbag, the daemon of ros2cli), nodes of libraries, and nodes that a known node creates. Silent as soon
as the files leave the name of one node open, because the running node may be that one.

## Why it matters on a robot
A leftover of yesterday's test, a second robot or a colleague's laptop publishes in the same domain, and the robot
obeys it as well.

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

## When to ignore it
When the node is a tool of yours that the linter does not know.

## References
- ROS 2 documentation, "The ROS_DOMAIN_ID"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", confidence="medium", silent="a further node is normal for ROS")
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
            f"{node.name} runs on domain {observed.graph.domain}, but no file starts it",
            advice="find out who started it; if it belongs to the robot, start it from a launch file",
            related=[note(each.where, f"this one is {each.name}") for each in same[:1]],
        )
