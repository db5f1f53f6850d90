"""An enclave may publish every topic, or use every service.

## What it finds
`*`, `rt/*` or a similar pattern among the topics that an enclave may publish, in permissions or in a policy.
`create_enclave` writes such permissions. Likewise `/*` among the services of a policy, or `rq/*` and `rr/*` among the
topics that an enclave may publish: it may call, or answer for, every service of the robot. A file that is called
permissive is an info, and so is what a comment above it says: `<!-- may call any service -->`.

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
from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.sros2 import Grant
from bringup_lint.api.sros2 import PolicyEnclave

TOPICS = "publish '{}', which is every topic of the robot"
VELOCITY = regex(r"\bcmd_vel\b")
CALLS = "call '{}', which is every service of the robot, including set_parameters of every node"
ANSWERS = "answer '{}', which is every service of the robot"
SAID = regex(r"<!--[^\n]{0,200}\b(?:any|all|every)\b", re.I, hints="<!--")
OF_GRANTS = {
    regex(r"(?:rt/)?\*+$"): TOPICS,
    regex(r"rq/\*+(?:Request)?$"): CALLS,
    regex(r"rr/\*+(?:Reply)?$"): ANSWERS,
}
OF_POLICIES = {("topic", "publish"): TOPICS, ("service", "request"): CALLS, ("service", "reply"): ANSWERS}
ALL = ("*", "**", "/*", "/**")


class Wide(NamedTuple):
    """A right that is too wide."""

    enclave: str
    text: str
    """What it allows, with a place for the pattern."""
    pattern: Located


@rule("warning", silent="nothing is refused, so nothing is reported", tags=["CWE-732"])
def permissions_wildcard_topic(robot: Robot) -> Iterator[Finding]:
    keystores: dict[str, list[Wide]] = {}
    for document, grant in robot.sros2.ros_grants:
        keystores.setdefault(document.source.name.partition("enclaves/")[0], []).extend(_of_grant(grant))
    for rights in keystores.values():
        rights.sort(key=lambda right: robot.purpose(right.pattern).value != "robot")
        yield from _by_right(robot, rights, "list what its nodes use, and sign the document again")
    for policy in robot.sros2.used_policies:
        rights = [right for enclave in policy.enclaves for right in _of_enclave(enclave)]
        yield from _by_right(robot, rights, "list what its nodes use (ros2 security generate_policy)")


def _of_grant(grant: Grant) -> Iterator[Wide]:
    """The widest right of a grant."""
    topics = [topic for allowed in grant.allowed for topic in allowed.publish]
    for wide, text in OF_GRANTS.items():
        matching = [topic for topic in topics if wide.match(topic)]
        if matching:
            yield Wide(str(grant.enclave), text, matching[0])
            return


def _of_enclave(enclave: PolicyEnclave) -> Iterator[Wide]:
    """The widest right of an enclave."""
    rights = [right for profile in enclave.profiles for right in profile.rights if right.name.strip() in ALL]
    for (kind, way), text in OF_POLICIES.items():
        names = [right.name for right in rights if right.kind == kind and right.allows(way)]
        if names:
            yield Wide(str(enclave.path), text, names[0])
            return


def _by_right(robot: Robot, rights: Iterable[Wide], advice: str) -> Iterator[Finding]:
    """One finding for all enclaves of a keystore or policy that have the same right."""
    found: dict[str, list[Wide]] = {}
    for each in rights:
        found.setdefault(each.text, []).append(each)
    for first, *others in found.values():
        who = f"{first.enclave} and {len(others)} more" if others else first.enclave
        yield finding(
            first.pattern,
            f"{who} may {first.text.format(first.pattern.strip())}{_also(robot, first)}",
            advice=advice,
            related=[note(each.pattern, f"the same for {each.enclave}") for each in others],
            severity="info" if _is_meant(first.pattern) else None,
        )


def _is_meant(pattern: Located) -> bool:
    """Whether the file is called permissive, or a comment above the pattern or its element says what it allows."""
    source = pattern.span.source
    above = (source.line_text(line) for line in range(max(pattern.span.line - 2, 1), pattern.span.line))
    return "permissive" in source.basename or any(map(SAID.search, above))


def _also(robot: Robot, right: Wide) -> str:
    return ", including /cmd_vel" if right.text == TOPICS and robot.mentions(VELOCITY) else ""
