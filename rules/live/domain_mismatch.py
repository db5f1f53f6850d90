"""The nodes run on another domain than the files say.

## What it finds
A tree whose files agree on one `ROS_DOMAIN_ID`, no node of the robot on that domain, and nodes of the robot on
another one that the files mention, on the default 0, or on the one that this program was told to look at. Also single
nodes that must run on the domain in the files and run on another one.

## Why it matters on a robot
The variable did not reach the processes: an env file that the unit does not load, a shell that was not sourced
again. Robot and operator station are on two networks that cannot see each other.

## Bad
```ini
# ros2.env, while the nodes run on domain 0
ROS_DOMAIN_ID=42
```

## Good
```ini
# ros2.env, loaded by every unit: the nodes run on domain 42
ROS_DOMAIN_ID=42
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


@rule("error")
def domain_mismatch(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    configured = observed.configured
    if configured is None:
        return
    by_domain = {**observed.elsewhere, observed.graph.domain: observed.nodes}
    ours = {domain: [node for node in nodes if belongs(observed, node)] for domain, nodes in by_domain.items()}
    file = configured.where.span.path.rpartition("/")[2]
    if ours.get(configured.number) == []:
        domain, nodes = next(((each, nodes) for each, nodes in sorted(ours.items()) if nodes), (None, []))
        if nodes:
            yield finding(
                configured.where,
                f"{file} says domain {configured.number}, where no node of the robot runs; "
                f"{count(nodes)} on domain {domain}",
                advice="see that every unit, container and shell that starts nodes loads this file",
                related=[note(node.name, f"runs on domain {domain}") for node in nodes[:3]],
            )
    elif observed.graph.domain == configured.number:
        for (entry, domain), nodes in observed.astray.items():
            yield finding(
                entry.where,
                f"{count(nodes)} on domain {domain}, not on {configured.number} as {file} says",
                advice=f"see that {entry.who or 'whoever starts this'} loads {file}",
                related=[
                    note(configured.where, "the domain of the others"),
                    *(note(node.name, f"runs on domain {domain}") for node in nodes[:3]),
                ],
            )


def count(nodes):
    return f"{nodes[0].name} runs" if len(nodes) == 1 else f"{len(nodes)} nodes run"


def belongs(observed, node):
    """Whether a node is the robot's, as far as the files tell names."""
    return observed.expected.named(node.name) is not None or not observed.expected.nodes
