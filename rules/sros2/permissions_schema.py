"""Elements of a permissions document are missing, unknown or repeated.

## What it finds
Elements of a permissions document that the specification does not know or that appear twice, a grant without
a name, subject or validity, and a validity without its start or end.

## Why it matters on a robot
The security plugin rejects the document: no node of the enclave starts.

## Bad
```xml
<validity>
  <not_before>2026-01-01T00:00:00</not_before>
</validity>
```

## Good
```xml
<validity>
  <not_before>2026-01-01T00:00:00</not_before>
  <not_after>2027-01-01T00:00:00</not_after>
</validity>
```

## When to ignore it
Never: the plugin rejects the whole document.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code

CODES = (Code.MISSING, Code.MISSING_ATTRIBUTE, Code.UNKNOWN, Code.DUPLICATE)


@rule(
    "error",
    symptoms=[
        "Expected not_after tag. Line",
        "Expected not_before tag. Line",
        "Expected validity tag. Line",
        "Expected subject_name tag. Line",
    ],
)
def permissions_schema(robot: Robot) -> Iterator[Finding]:
    for permissions in robot.sros2.permissions:
        for remark in permissions.remarks:
            if remark.code not in CODES or remark.detail == "default":
                continue
            rejected = "the document is rejected"
            if remark.code is Code.MISSING and remark.detail == "topic":
                message, advice = f"{remark.where} is empty", "add a topic, or delete it"
                rejected = "Fast DDS rejects the document"
            elif remark.code in (Code.MISSING, Code.MISSING_ATTRIBUTE):
                message, advice = f"{remark.where} has no {remark.detail}", f"add {remark.detail}"
            elif remark.code == Code.UNKNOWN:
                message, advice = f"{remark.detail} is not an element of permissions", "delete it"
            else:
                message, advice = f"{remark.detail} appears twice", "delete one of the two"
            yield finding(
                remark.where,
                f"{message}: {rejected}, no node of the enclave starts",
                advice=f"{advice}, and sign the document again",
            )
