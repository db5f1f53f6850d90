"""A node that the files start is not running.

## What it finds
Nodes that start on every boot but that the running graph does not show. A node starts on every boot if an installed
unit or a compose service runs its launch file, and its condition is absent or true by default. Without a unit or
service, the only launch file of the tree counts, or the one that `--launch` names.

Programs that finish their work and exit are not reported. Neither are other robots and variants in a repository:
the units of one folder, and the services of one compose file, count when a node that only they start is running, or
when nothing runs at all.

## Why it matters on a robot
The process list looks complete, but the robot is blind on one side. The node crashed, was never started, or has
another name or namespace than everything that waits for it expects.

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

## When to ignore it
When the node is stopped on purpose, or runs only in some missions.

## References
- ROS 2 documentation, "Understanding nodes"
"""

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

CRASHED = "look at its log: it crashed or was never started"


@rule("error", symptoms=["Node not found", "Unable to find node"])
def node_missing(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    domain = observed.graph.domain
    absent = {node.name for nodes in observed.missing.values() for node in nodes}
    if len(absent) > 1 and not observed.names & observed.expected.must:
        entry, nodes = next(iter(observed.missing.items()))
        due = {node.name for entry in observed.due for node in observed.expected.entries[entry]}
        seen = {other: {str(node.name) for node in there} for other, there in observed.elsewhere.items() if there}
        also = "".join(f"; {_shown(other, there, due)}" for other, there in seen.items())
        yield finding(
            entry.where,
            f"None of the {len(due)} nodes that the files start runs on domain {domain}{also}",
            advice=look_at(seen) if seen else "check whether anything was started at all, and in which domain",
            related=[note(node.where, f"{node.name} is started here") for node in nodes[:5]],
        )
        return
    for nodes in observed.missing.values():
        for node in nodes:
            other = observed.namesake(node.name)
            yield finding(
                node.where,
                f"{node.name} is not running on domain {domain}" + (f"; {other.name} is" if other else ""),
                advice="use the same name and namespace on both sides" if other else CRASHED,
                related=[*node.chain, *([note(other.name, "this one runs")] if other else [])],
            )


def look_at(domains: Iterable[int]) -> str:
    asked = " or ".join(f"--domain-id {domain}" for domain in domains)
    return f"look there with {asked}; what runs on another domain did not get the variable"


def _shown(domain: int, names: set[str], due: set[str]) -> str:
    """What another domain shows: nodes that should run on this one, or others of the robot."""
    there = len(names & due)
    if there:
        return f"{there} of them {'runs' if there == 1 else 'run'} on domain {domain}"
    return f"domain {domain} shows " + ("1 other node" if len(names) == 1 else f"{len(names)} other nodes")
