"""The running nodes are not secured as the files say.

## What it finds
The tree switches SROS2 on (`ROS_SECURITY_ENABLE=true`), and yet this program, without any credentials, sees the
robot's nodes; and nodes that run in another enclave than the one that their launch file selects.

## Why it matters on a robot
A participant that enforces security is invisible to one without credentials. Who can be seen can be commanded:
the variables did not reach the processes, or the strategy is permissive. A node in the enclave `/` has the
rights of no one, or of all.

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

## References
- ROS 2 design, "ROS 2 Security Enclaves"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", tags=["CWE-306"])
def enclave_unsecured(robot: Robot) -> Iterator[Finding]:
    observed = robot.observed
    seen = [node for node in observed.nodes if observed.expected.named(node.name) or not observed.expected.nodes]
    if observed.security and seen and not observed.graph.secured:
        some = ", ".join(str(node.name) for node in seen[:3]) + (", ..." if len(seen) > 3 else "")
        count = "1 node" if len(seen) == 1 else f"{len(seen)} nodes"
        yield finding(
            observed.security,
            f"Security is switched on here, and {count} of domain {observed.graph.domain} can be seen without "
            f"credentials ({some})",
            advice="see that the variables reach the processes, and set ROS_SECURITY_STRATEGY=Enforce",
            related=[note(node.name, "seen without credentials") for node in seen[:3]],
        )
    for node in {str(node.name): node for node in observed.nodes}.values():
        known = observed.expected.named(node.name)
        selected = robot.sros2.enclave_of(known.started)[1] if known and known.started else None
        if selected is None or node.enclave is None or selected == node.enclave or "$" in selected:
            continue
        yield finding(
            selected,
            f"{node.name} runs in the enclave {node.enclave}, not in {selected}",
            advice="start it from this file, with the arguments as they stand here",
            related=[note(node.enclave, "the enclave that it runs in"), *known.chain],
        )
