"""The policy of an enclave does not describe a node that runs in it.

## What it finds
A node that a launch file starts with `--enclave E`, whose full name is known, and for which the only policy
of the tree that describes E has no matching profile:
- **error**: the policy has a profile for a node of this name in another namespace.
- **warning**: it has no profile for the node at all.

Policies that include their profiles from other files, and profiles that allow everything, are not checked.

## Why it matters on a robot
sros2 resolves relative names and `~` of a profile with its namespace and node. The grants are for topics and
parameter services of a node that does not exist, and the real node is denied its own.

## Bad
```xml
<enclave path="/lawn/driver"><profiles>
  <profile ns="/" node="driver">
```
```python
Node(package="lawn", executable="driver", name="driver", namespace="lawn", ros_arguments=["--enclave", "/lawn/driver"])
```

## Good
```xml
<enclave path="/lawn/driver"><profiles>
  <profile ns="/lawn" node="driver">
```

## When to ignore it
If the profile is for another launch of the same enclave, and this node is only started in simulation or
without security.

## References
- sros2, creation of permissions from a policy
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Not Allowed By Security"])
def policy_node_mismatch(robot: Robot) -> Iterator[Finding]:
    for node, selected, enclave in robot.sros2.policed_nodes:
        names = {profile.fqn: profile for profile in enclave.profiles}
        if node.fqn is None or node.fqn in names:
            continue
        own = node.fqn.rpartition("/")[2]
        near = [profile for profile in enclave.profiles if profile.node == own]
        if len(near) == 1:
            yield finding(
                near[0].namespace,
                f"The rights are for {near[0].fqn}, but launch starts {node.fqn}: its relative topics and its "
                "parameter services are denied",
                advice=f'write ns="{node.fqn.rpartition("/")[0] or "/"}", and create and sign the permissions again',
                related=[note(node.span, f"{node.fqn} is started here"), note(selected, "with this enclave")],
            )
        else:
            yield finding(
                enclave.path,
                f"The policy of {enclave.path} has no profile for {node.fqn}, which launch starts in it: its parameter "
                "services are denied, the node ends",
                advice=f"add a profile for {node.fqn}, and create and sign the permissions again",
                related=[note(node.span, f"{node.fqn} is started here"), note(selected, "with this enclave")],
                severity="warning",
            )
