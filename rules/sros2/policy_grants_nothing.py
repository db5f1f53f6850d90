"""A right in a policy that becomes no right.

## What it finds
In a `policy.xml`: topics, services or actions without any of publish, subscribe, reply, request, call and execute; a
profile whose namespace does not begin with a slash; names with the DDS prefixes `rt/`, `rq/`, `rr/`; `~name` instead of
`~/name`; empty names and names with blanks.

## Why it matters on a robot
`ros2 security create_permission` takes all of them and writes a topic that nobody uses: the endpoint is denied when the
robot runs, and the node ends with an exception.

## Bad
```xml
<profile ns="lawn" node="driver">
  <topics>
    <topic>rt/odom</topic>
```

## Good
```xml
<profile ns="/lawn" node="driver">
  <topics publish="ALLOW">
    <topic>odom</topic>
```

## References
- sros2, how permissions are made of a policy
- ROS 2 design, "Topic and Service name mapping to DDS"
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

PREFIXED = re.compile(r"/?r[tqr]/(.+)")


@rule("error", fix="safe", symptoms=["Not Allowed By Security"])
def policy_grants_nothing(robot: Robot):
    for profile in robot.sros2.policy_profiles:
        if profile.namespace and not profile.namespace.startswith(("/", "$")):
            yield finding(
                profile.namespace,
                f"The namespace '{profile.namespace}' has no slash in front: relative names of {profile.node} become "
                f"rt{profile.namespace}/..., which nobody uses",
                advice=f"write /{profile.namespace}",
                fix=fix(f"write /{profile.namespace}", (profile.namespace, f"/{profile.namespace}")),
            )
        silent = {id(right.element): right.element for right in profile.rights if not right.ways}
        for element in silent.values():
            ways = WAYS[str(element.local)]
            yield finding(
                element.name,
                f"These {element.local} of {profile.fqn} say neither {' nor '.join(ways)}: nothing is granted",
                advice=f'write {ways[0]}="ALLOW"',
            )
        for right in profile.rights:
            wrong, correct = _fault(right)
            if wrong:
                yield finding(
                    right.name if right.name.strip() else right.element.name,
                    f"{_quoted(right)} {wrong}: {profile.fqn} is granted nothing",
                    advice=f"write {correct}" if correct else f"write the name of a {right.kind}",
                    fix=fix(f"write {correct}", (right.name, correct)) if correct else None,
                )


WAYS = {"topics": ("publish", "subscribe"), "services": ("reply", "request"), "actions": ("call", "execute")}


def _quoted(right) -> str:
    return f"'{right.name.strip()}'" if right.name.strip() else f"This {right.kind}"


def _fault(right) -> tuple[str, str]:
    """What is wrong with the name, and how it should be."""
    name = right.name.strip()
    if not name:
        return "is empty", ""
    prefixed = PREFIXED.fullmatch(name)
    if prefixed:
        return "is a name of DDS, a policy holds names of ROS", f"/{prefixed[1]}" if right.kind == "topic" else ""
    if name.startswith("~") and not name.startswith("~/"):
        return "is joined to the node's name without a slash", f"~/{name[1:]}" if name[1:] else ""
    if name != right.name or re.search(r"\s", name):
        return "has blanks, which become part of the name", name if not re.search(r"\s", name) else ""
    return "", ""
