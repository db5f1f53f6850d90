"""A security document is not well-formed XML.

## What it finds
XML errors in a governance document, a permissions document or a policy. A DOCTYPE is a warning.

## Why it matters on a robot
The security plugin reads no rule at all: the participant cannot be created and no node starts. A DOCTYPE is
useful only for attacks with entities, because its declarations are never loaded.

## Bad
```xml
<permissions>
  <grant name="/lawn/driver">
</permissions>
```

## Good
```xml
<permissions>
  <grant name="/lawn/driver"/>
</permissions>
```

## When to ignore it
Never: no library can read the document.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import Remark


@rule("error", symptoms=["Can not parse governance file", "Can not parse permissions file"])
def xml_not_wellformed(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.sros2.remarks(Code.XML):
        yield _finding(remark, "The document", "no node of these enclaves starts", " and sign the document again")
    for policy in robot.sros2.policies:
        for remark in policy.remarks:
            if remark.code == Code.XML:
                yield _finding(remark, "The policy", "ros2 security creates no permissions from it", "")


def _finding(remark: Remark, what: str, consequence: str, afterwards: str) -> Finding:
    if remark.xml == "doctype":
        message = "A DOCTYPE is not allowed here: its declarations are never loaded, and it enables entity attacks"
        return finding(remark.where, message, advice="delete the DOCTYPE", severity="warning")
    message = f"{what} cannot be parsed ({remark.xml_problem}): {consequence}"
    return finding(remark.where, message, advice=f"repair the XML{afterwards}")
