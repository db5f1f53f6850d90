"""A launched node for which the policy of its enclave speaks under another name, or not at all.

## What it finds
A node that a launch file starts with `--enclave E`, whose full name is known, where the one policy of the tree that
describes E has a profile for a node of this name in another namespace, or no profile for it. Policies that include
their profiles from elsewhere, and profiles that allow everything, are left alone.

## Why it matters on a robot
Relative names and `~` of a profile are resolved with its namespace and node: the grants are for topics and parameter
services of a node that does not exist, and the real one is denied its own.

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

## References
- sros2, how permissions are made of a policy
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Not Allowed By Security"])
def policy_node_mismatch(robot: Robot):
    for node, selected, enclave in robot.sros2.policed_nodes:
        names = {profile.fqn: profile for profile in enclave.profiles}
        if node.fqn in names:
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
