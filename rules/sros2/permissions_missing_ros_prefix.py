"""A topic in permissions is not a DDS name of ROS 2.

## What it finds
Topics of an enclave's grant that do not start with `rt/`, `rq/` or `rr/`, that start with a slash, or that
have two slashes after the prefix.

## Why it matters on a robot
ROS 2 adds `rt` to the names of topics, `rq` and `rr` to those of services. The grant matches nothing: the
endpoint is denied, and the node ends with an exception.

## Bad
```xml
<topic>/cmd_vel</topic>
```

## Good
```xml
<topic>rt/cmd_vel</topic>
```

## When to ignore it
If the topic belongs to a DDS program that does not use ROS 2, or to a node with
`avoid_ros_namespace_conventions`.

## References
- ROS 2 design, "Topic and Service name mapping to DDS"
- Cyclone DDS 0.10.5 with security, tested with the real library
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Not Allowed By Security"])
def permissions_missing_ros_prefix(robot: Robot) -> Iterator[Finding]:
    for _, grant in robot.sros2.ros_grants:
        for rule_ in grant.allowed:
            for topic in (*rule_.publish, *rule_.subscribe):
                right = _corrected(topic)
                if right is None:
                    continue
                yield finding(
                    topic,
                    f"'{topic}' grants nothing to {grant.enclave}: the DDS name of the ROS topic is {right}",
                    advice=f"write {right}, or rq/...Request and rr/...Reply for a service, and sign the document "
                    "again",
                    severity=None if "//" in topic or topic.startswith("/") else "warning",
                    fix=fix(f"write {right}", (topic, right)) if topic.startswith("/") else None,
                )


def _corrected(topic: Located) -> str | None:
    if re.match(r"(?:rt|rq|rr)//", topic):
        return re.sub(r"/+", "/", topic)
    if re.match(r"(?:rt|rq|rr|rs|ra|rp)/|ros_discovery_info$|DCPS|r?[*?\[]|r[tqr]?[*?\[]", topic) or not topic:
        return None
    return f"rt/{topic.lstrip('/')}"
