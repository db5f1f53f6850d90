"""A policy that sros2 does not accept.

## What it finds
Elements and attributes of a `policy.xml` that are missing, unknown, repeated or misplaced, words other than ALLOW and
DENY, text between elements, a namespace, and another version than 0.2.0. What `xi:include` brings is not looked at, and
may be what seems to be missing.

## Why it matters on a robot
`ros2 security create_permission` and `generate_artifacts` end with an error: the enclave keeps the permissions that it
had, after `create_enclave` those that allow everything.

## Bad
```xml
<topics publish="allow">
  <topic>odom</topic>
</topics>
```

## Good
```xml
<topics publish="ALLOW">
  <topic>odom</topic>
</topics>
```

## References
- sros2, policy schema 0.2.0; compared over 1,100 bred policies
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

MESSAGES = {
    "missing": "{where} lacks {detail}",
    "attribute": "{where} lacks the attribute {detail}",
    "unknown": "{detail} is no element of a policy at this place",
    "duplicate": "{detail} stands here twice",
    "order": "{detail} is out of order",
    "version": "Version {detail} is not 0.2.0",
    "namespace": "A policy has no namespace",
    "unknown attribute": "{detail} is no attribute of this element",
    "qualifier": "'{where}' is neither ALLOW nor DENY",
    "text": "{detail} holds elements, no text",
}


@rule("error", fix="safe", symptoms=["No matching global declaration", "SCHEMAV_CVC"])
def policy_schema(robot: Robot):
    for policy in robot.sros2.policies:
        for remark in policy.remarks:
            if remark.code not in MESSAGES:
                continue
            what = MESSAGES[remark.code].format(where=remark.where, detail=remark.detail)
            right = str(remark.where).strip().upper() if remark.code == "qualifier" else ""
            yield finding(
                remark.where,
                f"{what}: ros2 security ends with an error, the permissions stay as they were",
                advice=f"write {right}" if right in ("ALLOW", "DENY") else "follow sros2's policy schema 0.2.0",
                fix=fix(f"write {right}", (remark.where, right)) if right in ("ALLOW", "DENY") else None,
            )
