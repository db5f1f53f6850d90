"""Elements of a governance document are missing, unknown or out of order.

## What it finds
Elements of a governance document that are missing, unknown, repeated, empty, or not in the order of the
specification. Cyclone DDS accepts another order; Fast DDS reads strictly in sequence.

## Why it matters on a robot
The security plugin rejects the document when the participant is created (code 110): no node of the robot
starts. Examples often omit `enable_liveliness_protection`.

## Bad
```xml
<topic_rule>
  <topic_expression>*</topic_expression>
  <enable_discovery_protection>true</enable_discovery_protection>
  <enable_read_access_control>true</enable_read_access_control>
```

## Good
```xml
<topic_rule>
  <topic_expression>*</topic_expression>
  <enable_discovery_protection>true</enable_discovery_protection>
  <enable_liveliness_protection>true</enable_liveliness_protection>
  <enable_read_access_control>true</enable_read_access_control>
```

## When to ignore it
Only for the order of elements, if every computer of the robot uses Cyclone DDS.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import Remark


@rule("error", fix="unsafe", symptoms=["Found topic rule in Governance file without", "code: 110"])
def governance_schema(robot: Robot) -> Iterator[Finding]:
    for document, remark in robot.sros2.remarks(Code.MISSING, Code.UNKNOWN, Code.DUPLICATE, Code.ORDER, Code.EMPTY):
        if document not in robot.sros2.governances:
            continue
        if remark.code == Code.MISSING:
            yield finding(
                remark.where,
                f"{remark.where} has no {remark.detail}: the document is rejected (code 110), no node starts",
                advice=f"add {remark.detail}{_place(remark)}, and sign the document again",
                fix=_insertion(remark),
            )
        elif remark.code == Code.ORDER and not robot.sros2.is_used(document.source):
            continue
        elif remark.code == Code.ORDER:
            yield finding(
                remark.where,
                f"{remark.detail} is out of order: Cyclone DDS accepts it, Fast DDS rejects the document and no node "
                "starts",
                advice="keep the order of the specification, and sign the document again",
            )
        elif remark.code == Code.EMPTY:
            yield finding(
                remark.where,
                f"{remark.detail} is empty: it covers no topic",
                advice="write a topic name or a pattern, such as *",
            )
        else:
            what = "is not an element of a governance document" if remark.code == Code.UNKNOWN else "appears twice"
            yield finding(
                remark.where,
                f"{remark.detail} {what}: the document is rejected, no node starts",
                advice="delete it, and sign the document again",
            )


def _place(remark: Remark) -> str:
    return f" before {remark.before.local}" if remark.before is not None else ""


def _insertion(remark: Remark) -> Fix | None:
    """Switch on what is missing, on a line of its own."""
    if not remark.detail.startswith("enable_") or remark.before is None:
        return None
    tag = remark.before.tag
    line = tag.source.line_text(tag.line)
    indent = line[: len(line) - len(line.lstrip())]
    element = f"<{remark.detail}>true</{remark.detail}>\n{indent}"
    return fix(f"add {remark.detail}", (Span(tag.source, tag.start, tag.start), element), safe=False)
