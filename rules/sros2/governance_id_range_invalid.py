"""A range of domains has no minimum, or a minimum above its maximum.

## What it finds
An `id_range` without `min`, or with `min` above `max`, or a domain that is not a number, in governance and
permissions documents. Schema validators accept the first two.

## Why it matters on a robot
Cyclone DDS rejects the document (code 110): no participant is created and no node starts.

## Bad
```xml
<id_range>
  <min>10</min>
  <max>0</max>
</id_range>
```

## Good
```xml
<id_range>
  <min>0</min>
  <max>10</max>
</id_range>
```

## When to ignore it
Never: Cyclone DDS rejects the document as a whole.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["Found domain range in Governance file without minimum value", "with invalid range"])
def governance_id_range_invalid(robot: Robot) -> Iterator[Finding]:
    for document, remark in robot.sros2.remarks(Code.RANGE, Code.NUMBER):
        code = " (code 110)" if document in robot.sros2.governances else ""
        if remark.code == Code.NUMBER:
            text = remark.inside.text
            message = f"'{text}' is not a domain" if text else f"{remark.detail} is empty"
        else:
            message = f"The range of domains is not valid ({remark.detail})"
        yield finding(
            remark.where,
            f"{message}: the document is rejected{code}, no node starts",
            advice="write min and max, the smaller first, and sign the document again",
        )
