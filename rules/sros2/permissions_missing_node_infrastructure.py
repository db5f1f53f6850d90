"""Permissions do not include the topics that every node publishes.

## What it finds
A grant to an enclave that does not allow publishing `rt/rosout` or `rt/parameter_events`, and an enclave of a policy,
from which sros2 makes such a grant, also in the template of a policy and in one that a script writes. Silent where a
policy includes rights from elsewhere, or a template or a script fills in one. An info where nothing makes permissions
from such a policy.

## Why it matters on a robot
The constructor of a node creates these publishers, unless the node switches them off, and throws at the first
one that is denied: the node does not start.

## Bad
```xml
<topic>rt/odom</topic>
```

## Good
```xml
<topic>rt/rosout</topic>
<topic>rt/parameter_events</topic>
<topic>rt/odom</topic>
```

## When to ignore it
If every node of the enclave disables the two publishers in its NodeOptions (`enable_rosout(false)`,
`start_parameter_event_publisher(false)`).

## References
- https://github.com/ros2/sros2/issues/65
- Cyclone DDS 0.10.5 with security, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.sros2 import PolicyEnclave
from bringup_lint.api.sros2 import matches

NEEDED = ("rt/rosout", "rt/parameter_events")


@rule("warning", symptoms=["Not Allowed By Security"])
def permissions_missing_node_infrastructure(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.ros_grants:
        if grant.default == "ALLOW" or not grant.allowed:
            continue
        topics = [topic for each in grant.allowed for topic in each.publish]
        lacks = [name for name in NEEDED if not any(matches(name, topic) for topic in topics)]
        if lacks:
            yield finding(
                grant.place,
                f"{grant.enclave} cannot publish {' and '.join(lacks)}: a normal node throws when it is created",
                advice=f"add {' and '.join(lacks)} to publish, and sign the document again",
            )
    for enclave in robot.sros2.policy_enclaves:
        lacks = [name[len("rt/") :] for name in NEEDED if not _publishes(enclave, name)]
        if lacks and enclave.profiles:
            yield finding(
                enclave.path,
                f"{enclave.path} cannot publish {' and '.join(lacks)}: a normal node throws when it is created",
                advice=f"let it publish /{' and /'.join(lacks)}, and create the permissions again",
                severity="info" if robot.sros2.is_unapplied(enclave.path) else None,
            )


def _publishes(enclave: PolicyEnclave, topic: str) -> bool:
    """Whether a profile of the enclave lets its node publish a topic; names without a slash are in its namespace."""
    for profile in enclave.profiles:
        for right in profile.rights:
            name = right.name.strip()
            full = name if name.startswith("/") else f"{profile.namespace.rstrip('/')}/{name}"
            if right.kind == "topic" and right.allows("publish") and matches(topic, f"rt{full}"):
                return True
    return False
