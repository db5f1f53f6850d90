"""A right in a policy grants nothing.

## What it finds
Rights in a `policy.xml` that have no effect:
- topics, services or actions without publish, subscribe, reply, request, call or execute
- a profile whose namespace does not start with a slash
- names with the DDS prefixes `rt/`, `rq/`, `rr/`, unless the same rights are granted under the right name beside them
- `~name` instead of `~/name`
- empty names, and names with spaces

## Why it matters on a robot
`ros2 security create_permission` accepts all of them and writes a topic that nothing uses. The endpoint is
denied when the robot runs, and the node ends with an exception.

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

## When to ignore it
Never: the permissions that sros2 creates from it match no endpoint.

## References
- sros2, creation of permissions from a policy
- ROS 2 design, "Topic and Service name mapping to DDS"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.sros2 import Right
from bringup_lint.api.sros2 import matches
from bringup_lint.api.templates import has_placeholder

PREFIXED = regex(r"/?r[tqr]/(.+)")


@rule("error", fix="unsafe", symptoms=["Not Allowed By Security"])
def policy_grants_nothing(robot: Robot) -> Iterator[Finding]:
    for profile in robot.sros2.policy_profiles:
        is_known = profile.namespace and not has_placeholder(profile.namespace)
        if is_known and not profile.namespace.startswith(("/", "$")):
            yield finding(
                profile.namespace,
                f"The namespace '{profile.namespace}' has no leading slash: relative names of {profile.node} become "
                f"rt{profile.namespace}/..., which nothing uses",
                advice=f"write /{profile.namespace}",
                fix=fix(f"write /{profile.namespace}", (profile.namespace, f"/{profile.namespace}")),
            )
        silent = dict.fromkeys(right.element for right in profile.rights if not right.ways)
        for element in silent:
            ways = WAYS[str(element.local)]
            yield finding(
                element.name,
                f"The {element.local} of {profile.fqn} have neither {' nor '.join(ways)}: nothing is granted",
                advice=f'write {ways[0]}="ALLOW"',
            )
        for right in profile.rights:
            wrong, correct = _fault(right)
            is_granted = any(_covers(other, right, correct) for other in profile.rights)
            if wrong and not is_granted:
                yield finding(
                    right.name if right.name.strip() else right.element.name,
                    f"{_quoted(right)} {wrong}: {profile.fqn} is granted nothing",
                    advice=f"write {correct}" if correct else f"write the name of a {right.kind}",
                    fix=fix(f"write {correct}", (right.name, correct)) if correct else None,
                )


WAYS = {"topics": ("publish", "subscribe"), "services": ("reply", "request"), "actions": ("call", "execute")}


def _covers(other: Right, right: Right, name: str) -> bool:
    """Whether another right of the same element is for a name."""
    pattern = other.name.strip()
    return (
        bool(name)
        and other.element is right.element
        and pattern != right.name
        and matches(name, f"/{pattern.lstrip('/')}")
    )


def _quoted(right: Right) -> str:
    return f"'{right.name.strip()}'" if right.name.strip() else f"This {right.kind}"


def _fault(right: Right) -> tuple[str, str]:
    """What is wrong with the name, and how it should be."""
    name = right.name.strip()
    if not name:
        return "is empty", ""
    prefixed = PREFIXED.fullmatch(name)
    if prefixed:
        return "is a DDS name, but a policy contains ROS names", f"/{prefixed[1]}" if right.kind == "topic" else ""
    if name.startswith("~") and not name.startswith("~/"):
        return "is joined to the node's name without a slash", f"~/{name[1:]}" if name[1:] else ""
    if name != right.name or re.search(r"\s", name):
        return "has spaces, which become part of the name", name if not re.search(r"\s", name) else ""
    return "", ""
