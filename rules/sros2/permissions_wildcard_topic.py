"""An enclave may publish every topic.

## What it finds
`*`, `rt/*` or a similar pattern among the topics that an enclave may publish, in permissions or in a policy.
`create_enclave` writes such permissions.

## Why it matters on a robot
Whoever takes over one process of the robot, for example the camera driver, can publish on /cmd_vel.

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

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sros2 import PolicyEnclave


@rule("warning", tags=["CWE-732"])
def permissions_wildcard_topic(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.ros_grants:
        for rule_ in grant.allowed:
            wide = [topic for topic in rule_.publish if topic.rstrip("*") in ("", "rt/") and topic.endswith("*")]
            if wide:
                yield finding(
                    wide[0],
                    f"{grant.enclave} may publish '{wide[0]}', which is every topic of the robot, including /cmd_vel",
                    advice="list the topics that its nodes publish (ros2 security generate_policy), and sign the "
                    "document again",
                    related=[note(other, "and this one") for other in wide[1:]],
                )
    for policy in robot.sros2.used_policies:
        for enclave in policy.enclaves:
            yield from _of_policy(enclave)


def _of_policy(enclave: PolicyEnclave) -> Iterator[Finding]:
    rights = (right for profile in enclave.profiles for right in profile.rights)
    wide = [
        right.name
        for right in rights
        if right.kind == "topic" and right.allows("publish") and right.name.strip() in ("*", "/*", "/**")
    ]
    if wide:
        yield finding(
            wide[0],
            f"{enclave.path} may publish '{wide[0].strip()}', which is every topic of the robot, including /cmd_vel",
            advice="list the topics that its nodes publish (ros2 security generate_policy)",
            related=[note(other, "and this one") for other in wide[1:]],
        )
