"""A Cyclone DDS size or duration without a unit.

## What it finds
A bare number for a size, which means bytes, or for a duration, which means milliseconds (microseconds
for `RetransmitMergingPeriod`), not seconds. Durations for which the library insists on a unit are found
by `cyclonedds/bad-unit`.

## Why it matters on a robot
`<LeaseDuration>10</LeaseDuration>` is a lease of 10 ms: participants lose each other all the time. For
sizes the library only warns, at every start of every process.

## Bad
```xml
<LeaseDuration>10</LeaseDuration>
```

## Good
```xml
<LeaseDuration>10s</LeaseDuration>
```

## References
- Cyclone DDS 0.10.5 and 11.0.1, tried with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("warning", fix="safe", symptoms=["use of default unit is deprecated"])
def missing_unit(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.remarks(Code.BARE_NUMBER):
        unit = remark.detail
        value = remark.where
        plain = value.strip().isdigit()
        if unit == "B":
            message = f"{remark.item.name} {value} is read as {value} bytes, with a warning at every start"
        else:
            message = f"{remark.item.name} {value} is read as {value} {unit}, not seconds"
        yield finding(
            value,
            message,
            advice=f"write the unit: {value}{unit}",
            severity="info" if unit == "B" else None,
            fix=fix(f"append {unit}", (value, f"{value}{unit}")) if plain else None,
        )
