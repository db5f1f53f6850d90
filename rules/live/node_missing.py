"""A node that the files start does not run.

## What it finds
Nodes that are started on every boot (by a launch file that an installed unit or a compose service runs, without
condition or under one that holds by default) and that the running graph does not show. Without a unit or
service the only launch file of the tree counts, or what `--launch` names. Programs that do their work and end
are left out; so are other robots and variants in a repository: the units of one place, and the services of one
compose file, count when a node that only they start is there, or when nothing is there at all.

## Why it matters on a robot
The process list looks full and the robot misses an eye: the node crashed, was never started, or answers to
another name or namespace than everything that waits for it.

## Bad
```yaml
nodes:
- {name: /slam, enclave: /}
```

## Good
```yaml
nodes:
- {name: /lidar/driver, enclave: /}
- {name: /slam, enclave: /}
```

## References
- ROS 2 documentation, "Understanding nodes"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

CRASHED = "look at its log: it crashed or was never started"


@rule("error")
def node_missing(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    domain = observed.graph.domain
    count = len({node.name for nodes in observed.missing.values() for node in nodes})
    if count > 1 and not observed.names & observed.expected.must:
        entry, nodes = next(iter(observed.missing.items()))
        yield finding(
            entry.where,
            f"None of the {count} nodes that the files start runs on domain {domain}",
            advice="see whether anything was started at all, and in which domain",
            related=[note(node.where, f"{node.name} is started here") for node in nodes[:5]],
        )
        return
    for nodes in observed.missing.values():
        for node in nodes:
            other = observed.namesake(node.name)
            yield finding(
                node.where,
                f"{node.name} does not run on domain {domain}" + (f"; {other.name} does" if other else ""),
                advice="use the same name and namespace on both sides" if other else CRASHED,
                related=[*node.chain, *([note(other.name, "this one runs")] if other else [])],
            )
