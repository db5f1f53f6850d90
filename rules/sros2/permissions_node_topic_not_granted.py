"""A node uses a topic that its enclave does not allow.

## What it finds
A node that a launch file starts with `--enclave`, and that publishes or subscribes to a topic that the
permissions of that enclave do not allow. The topic is compared by its full name, after namespace, parameters
and remappings. Topics whose name is not known are skipped.

## Why it matters on a robot
The middleware denies the endpoint, and the constructor of the node throws: with security enforced the node
never starts. The usual cause is a namespace that was added later.

## Bad
```xml
<subscribe><topics><topic>rt/cmd_vel</topic></topics></subscribe>   <!-- the node runs in /lawn -->
```

## Good
```xml
<subscribe><topics><topic>rt/lawn/cmd_vel</topic></topics></subscribe>
```

## When to ignore it
If the node creates the endpoint only in a mode that this robot never uses, or if the permissions in the tree
are not those that are deployed.

## References
- ROS 2 design, "ROS 2 DDS-Security integration"
- Cyclone DDS 0.10.5 with security, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["not found in allow rule", "Not Allowed By Security"])
def permissions_node_topic_not_granted(robot: Robot) -> Iterator[Finding]:
    for use, grant, enclave, near in robot.sros2.ungranted:
        verb = "publish" if use.role == "publisher" else "subscribe"
        instead = f", but only {near} is granted" if near is not None else ", which is not granted"
        yield finding(
            near if near is not None else grant.place,
            f"{use.node.label()} has a {use.role} for rt{use.topic}{instead}: the node is denied and ends",
            advice=f"add <topic>rt{use.topic}</topic> to {verb}, and sign the document again",
            chain=robot.provenance.chain_to_node(
                use.node.started, note(use.where, f"{use.topic} is the {use.role}'s topic")
            ),
            related=[
                note(use.where, f"{use.node.label()} creates the {use.role} here"),
                note(enclave, "the process selects the enclave here"),
            ],
        )
