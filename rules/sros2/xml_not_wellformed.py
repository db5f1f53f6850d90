"""A security document that is not well-formed XML.

## What it finds
XML errors in a governance or permissions document or a policy, and a DOCTYPE.

## Why it matters on a robot
The security plugin reads no rule at all: the participant cannot be created and no node starts. A DOCTYPE only
serves attacks with entities; nothing of it is ever loaded.

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

## References
- Cyclone DDS 0.10.5 with security, tried with the real library
- OMG DDS Security 1.1, clause 9.4.1
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Can not parse governance file", "Can not parse permissions file"])
def xml_not_wellformed(robot: Robot):
    for _, remark in robot.sros2.remarks("xml"):
        yield _finding(remark, "The document", "no node of these enclaves starts", " and sign the document again")
    for policy in robot.sros2.policies:
        for remark in policy.remarks:
            if remark.code == "xml":
                yield _finding(remark, "The policy", "ros2 security makes no permissions of it", "")


def _finding(remark, what, consequence, afterwards):
    if remark.detail.startswith("doctype"):
        message = "A DOCTYPE has no place here: what it declares is never loaded, and it is a way in for attacks"
        return finding(remark.where, message, advice="delete the DOCTYPE", severity="warning")
    message = f"{what} cannot be read ({remark.detail}): {consequence}"
    return finding(remark.where, message, advice=f"repair the XML{afterwards}")
