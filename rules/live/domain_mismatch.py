"""The nodes run on a domain other than the configured one.

## What it finds
A tree whose files agree on one `ROS_DOMAIN_ID`, while no node of the robot runs on that domain. The nodes run on
another domain that the files mention, on the default domain 0, on one of which the computer has ports open, or on the
domain that was given on the command line. The domain on which most of them run is reported.
Single nodes that run on another domain than the files say are also reported.

## Why it matters on a robot
The variable did not reach the processes: the unit does not load the environment file, or a shell was not sourced
again. The robot and the operator station are on two networks that cannot see each other.

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

## When to ignore it
When you started the nodes by hand on another domain for a test.

## References
- ROS 2 documentation, "The ROS_DOMAIN_ID"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.live import Entry
from bringup_lint.api.live import Observed
from bringup_lint.api.live import RunningNode


@rule("error", silent="nodes of different domains do not see each other, and neither side reports it")
def domain_mismatch(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    configured = observed.configured
    if configured is None:
        return
    by_domain = {**observed.elsewhere, observed.graph.domain: observed.nodes}
    ours = {domain: [node for node in nodes if belongs(observed, node)] for domain, nodes in by_domain.items()}
    file = configured.where.span.path.rpartition("/")[2]
    if ours.get(configured.number) == []:
        domain, nodes = max(sorted(ours.items()), key=lambda each: len(each[1]))
        if nodes:
            yield finding(
                configured.where,
                f"{file} says domain {configured.number}, where no node of the robot runs; "
                f"{count(nodes)} on domain {domain}",
                advice="make every unit, container and shell that starts nodes load this file",
                related=[note(node.name, f"runs on domain {domain}") for node in nodes[:3]],
            )
    elif observed.graph.domain == configured.number:
        for (entry, domain), nodes in observed.astray.items():
            yield finding(
                entry.where,
                f"{count(nodes)} on domain {domain}, but {file} says {configured.number}",
                advice=advice(observed, entry, file),
                related=[
                    note(configured.where, "the domain of the others"),
                    *(note(node.name, f"runs on domain {domain}") for node in nodes[:3]),
                ],
            )


def advice(observed: Observed, entry: Entry, file: str) -> str:
    who = entry.who or "whatever starts this"
    if observed.sets_domain(entry):
        return f"{who} loads {file}: restart it, and look for what starts nodes without it, such as a shell"
    return f"make {who} load {file}"


def count(nodes: list[RunningNode]) -> str:
    return f"{nodes[0].name} runs" if len(nodes) == 1 else f"{len(nodes)} nodes run"


def belongs(observed: Observed, node: RunningNode) -> bool:
    """Whether a node is the robot's, as far as the files name their nodes."""
    return observed.expected.named(node.name) is not None or not observed.expected.nodes
