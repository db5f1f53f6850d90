"""Topics are not protected on the network.

## What it finds
A topic rule with `metadata_protection_kind` and `data_protection_kind` NONE, in a domain rule with
`rtps_protection_kind` NONE:
- **error**: the rule covers topics that move or stop the robot.
- **info**: it covers other topics.

## Why it matters on a robot
Messages are sent in clear text and unsigned: anyone on the network can read them and forge commands.

## Bad
```xml
<rtps_protection_kind>NONE</rtps_protection_kind>
...
<metadata_protection_kind>NONE</metadata_protection_kind>
<data_protection_kind>NONE</data_protection_kind>
```

## Good
```xml
<rtps_protection_kind>SIGN</rtps_protection_kind>
...
<metadata_protection_kind>ENCRYPT</metadata_protection_kind>
<data_protection_kind>ENCRYPT</data_protection_kind>
```

## When to ignore it
If the data may be public and forging it does no harm, such as camera images for a display, and encryption
would cost too much CPU time.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sros2 import moves_robot


@rule("error", fix="unsafe", silent="messages arrive in clear text without a message", tags=["CWE-319"])
def governance_protection_none(robot: Robot) -> Iterator[Finding]:
    for governance in robot.sros2.used_governances:
        for rule_ in governance.rules:
            if rule_.fields.get("rtps_protection_kind") != "NONE":
                continue
            for topics in rule_.topic_rules:
                metadata, data = (topics.fields.get(f"{part}_protection_kind") for part in ("metadata", "data"))
                if metadata != "NONE" or data is None or data != "NONE" or topics.expression is None:
                    continue
                yield finding(
                    data,
                    f"Nothing protects {topics.expression}: its messages can be read and forged on the network",
                    advice="write ENCRYPT (or SIGN), and sign the document again",
                    severity=None if moves_robot(topics.expression) else "info",
                    related=[note(rule_.fields["rtps_protection_kind"], "RTPS messages are not protected either")],
                    fix=fix("write ENCRYPT", (data, "ENCRYPT"), safe=False),
                )
