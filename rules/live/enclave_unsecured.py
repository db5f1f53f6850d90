"""The running nodes are not secured as configured.

## What it finds
Two contradictions with the files. The tree enables SROS2 (`ROS_SECURITY_ENABLE=true`), but this program sees the
robot's nodes without any credentials. A node runs in another enclave than the one that its launch file selects.

## Why it matters on a robot
A participant that enforces security is invisible without credentials. A visible node accepts commands from anybody:
the variables did not reach the processes, or the strategy is permissive. A node in another enclave has the wrong
permissions.

## Bad
```yaml
secured: false
nodes:
- {name: /motor, enclave: /}
```

## Good
```yaml
secured: true
nodes:
- {name: /motor, enclave: /motor}
```

## When to ignore it
When security is disabled on purpose during commissioning.

## References
- ROS 2 design, "ROS 2 Security Enclaves"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sros2 import enclave_of


@rule("error", silent="nodes start without security and without a message", tags=["CWE-306"])
def enclave_unsecured(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    seen = [node for node in observed.nodes if observed.expected.named(node.name) or not observed.expected.nodes]
    if observed.security and seen and not observed.graph.secured:
        some = ", ".join(str(node.name) for node in seen[:3]) + (", ..." if len(seen) > 3 else "")
        count = "1 node" if len(seen) == 1 else f"{len(seen)} nodes"
        yield finding(
            observed.security,
            f"Security is enabled here, but {count} of domain {observed.graph.domain} can be seen without credentials "
            f"({some})",
            advice="make sure that the variables reach the processes, and set ROS_SECURITY_STRATEGY=Enforce",
            related=[note(node.name, "seen without credentials") for node in seen[:3]],
        )
    for node in {str(node.name): node for node in observed.nodes}.values():
        known = observed.expected.named(node.name)
        selected = enclave_of(known.started)[1] if known and known.started else None
        if known is None or selected is None or node.enclave is None or selected == node.enclave or "$" in selected:
            continue
        yield finding(
            selected,
            f"{node.name} runs in the enclave {node.enclave}, not in {selected}",
            advice="start it from this file, with the arguments that it contains",
            related=[note(node.enclave, "the enclave that it runs in"), *known.chain],
        )
