"""A node whose enclave may not use one of its topics.

## What it finds
A node that a launch file starts with `--enclave`, and that publishes or subscribes a topic, under its full name after
namespace, parameters and remappings, which the permissions of that enclave do not allow. Names that are not known
are left alone.

## Why it matters on a robot
The middleware refuses the endpoint, and the constructor of the node throws: with security enforced the node never
starts. A namespace that came later is the usual cause.

## Bad
```xml
<subscribe><topics><topic>rt/cmd_vel</topic></topics></subscribe>   <!-- the node runs in /lawn -->
```

## Good
```xml
<subscribe><topics><topic>rt/lawn/cmd_vel</topic></topics></subscribe>
```

## References
- ROS 2 design, "ROS 2 DDS-Security integration"
- Cyclone DDS 0.10.5 with security, tried with the real library
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["not found in allow rule", "Not Allowed By Security"])
def permissions_node_topic_not_granted(robot: Robot):
    for use, grant, enclave, near in robot.sros2.ungranted:
        verb = "publish" if use.role == "publisher" else "subscribe"
        instead = f", granted is {near}" if near is not None else ""
        yield finding(
            near if near is not None else grant.subject,
            f"{use.node.label()} has to {verb} rt{use.topic}{instead}: the {use.role} is denied and the node ends",
            advice=f"add <topic>rt{use.topic}</topic> to {verb}, and sign the document again",
            chain=robot.provenance.chain_to_node(
                use.node.started, note(use.where, f"{use.topic} is the {use.role}'s topic")
            ),
            related=[
                note(use.where, f"{use.node.label()} makes the {use.role} here"),
                note(enclave, "the process selects the enclave here"),
            ],
        )
