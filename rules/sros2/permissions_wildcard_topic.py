"""An enclave may publish every topic, or use every service.

## What it finds
`*`, `rt/*` or a similar pattern among the topics that an enclave may publish, in permissions or in a policy.
`create_enclave` writes such permissions. Likewise `/*` among the services of a policy, or `rq/*` and `rr/*` among
the topics that an enclave may publish: it may call, or answer for, every service of the robot.

## Why it matters on a robot
Whoever takes over one process of the robot, for example the camera driver, can publish on /cmd_vel. Whoever
may call every service sets the parameters of every node, and shuts down those with a lifecycle.

## Bad
```xml
<publish>
  <topics>
    <topic>rt/*</topic>
  </topics>
</publish>
```

## Good
```xml
<publish>
  <topics>
    <topic>rt/camera/image</topic>
  </topics>
</publish>
```

## When to ignore it
For a tool that has to publish any topic, such as a rosbag player, if its enclave is not deployed on the
robot.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

TOPICS = "publish '{}', which is every topic of the robot, including /cmd_vel"
CALLS = "call '{}', which is every service of the robot, including set_parameters of every node"
ANSWERS = "answer '{}', which is every service of the robot"
OF_GRANTS = {
    re.compile(r"(?:rt/)?\*+$"): TOPICS,
    re.compile(r"rq/\*+(?:Request)?$"): CALLS,
    re.compile(r"rr/\*+(?:Reply)?$"): ANSWERS,
}
OF_POLICIES = {("topic", "publish"): TOPICS, ("service", "request"): CALLS, ("service", "reply"): ANSWERS}
ALL = ("*", "/*", "/**")


@rule("warning", tags=["CWE-732"])
def permissions_wildcard_topic(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.ros_grants:
        topics = [topic for allowed in grant.allowed for topic in allowed.publish]
        wide = [(text, topic) for pattern, text in OF_GRANTS.items() for topic in topics if pattern.match(topic)]
        yield from _wide(str(grant.enclave), wide, "list what its nodes use, and sign the document again")
    for policy in robot.sros2.used_policies:
        for enclave in policy.enclaves:
            rights = [right for profile in enclave.profiles for right in profile.rights if right.name.strip() in ALL]
            wide = [
                (text, right.name)
                for (kind, way), text in OF_POLICIES.items()
                for right in rights
                if right.kind == kind and right.allows(way)
            ]
            yield from _wide(str(enclave.path), wide, "list what its nodes use (ros2 security generate_policy)")


def _wide(enclave: str, wide: list[tuple[str, Located]], advice: str) -> Iterator[Finding]:
    """One finding for an enclave: the widest right, and the others beside it."""
    if wide:
        (text, name), *others = wide
        yield finding(
            name,
            f"{enclave} may {text.format(name.strip())}",
            advice=advice,
            related=[note(other, "and this one") for _, other in others],
        )
