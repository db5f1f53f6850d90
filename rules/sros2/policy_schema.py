"""sros2 does not accept a policy.

## What it finds
Mistakes in the structure of a `policy.xml`, of its template, or of one that a script writes: elements and attributes
that are missing, unknown, repeated or misplaced, words other than ALLOW and DENY, text between elements, an XML
namespace, and a version other than 0.2.0. An info where nothing makes permissions from the policy. Files that
`xi:include` adds are not read, so nothing that they may contain is reported as missing.

## Why it matters on a robot
`ros2 security create_permission` and `generate_artifacts` end with an error. The enclave keeps its previous
permissions; after `create_enclave` those allow everything.

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

## When to ignore it
If the policy is a template that a script completes before it calls sros2.

## References
- sros2, policy schema 0.2.0; compared over 1,100 generated policies
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import wrong_value
from bringup_lint.api.templates import has_placeholder

MESSAGES: dict[str, str] = {
    Code.MISSING: "{where} has no {detail}",
    Code.MISSING_ATTRIBUTE: "{where} has no attribute {detail}",
    Code.UNKNOWN: "{detail} is not allowed here in a policy",
    Code.SHAPE: "{detail} is not allowed here in a policy",
    Code.DUPLICATE: "{detail} appears twice",
    Code.ORDER: "{detail} is out of order",
    Code.VERSION: "Version {detail} is not 0.2.0",
    Code.NAMESPACE: "A policy must not have an XML namespace",
    Code.UNKNOWN_ATTRIBUTE: "{detail} is not an attribute of this element",
    Code.ENUM: "'{where}' is neither ALLOW nor DENY",
    Code.TEXT: "{detail} contains text, but only elements are allowed",
}


@rule("error", fix="safe", symptoms=["No matching global declaration", "SCHEMAV_CVC"])
def policy_schema(robot: Robot) -> Iterator[Finding]:
    for policy in robot.sros2.policies_and_templates:
        for remark in policy.remarks:
            is_to_fill = isinstance(remark.where, str) and has_placeholder(remark.where)
            if remark.code not in MESSAGES or is_to_fill:
                continue
            what = MESSAGES[remark.code].format(where=remark.where, detail=remark.detail)
            right = str(remark.where).strip().upper() if remark.code == Code.ENUM else ""
            yield wrong_value(
                remark.where,
                f"{what}: ros2 security fails, the permissions do not change",
                right if right in ("ALLOW", "DENY") else None,
                "follow sros2's policy schema 0.2.0",
                severity="info" if robot.sros2.is_unapplied(remark.where) else None,
            )
