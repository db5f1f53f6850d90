"""A Cyclone DDS size or duration has no unit.

## What it finds
A number without a unit:
- **warning**: a duration, which is read as milliseconds (microseconds for `RetransmitMergingPeriod`), not as
  seconds.
- **info**: a size, which is read as bytes.

Durations for which the library requires a unit are reported by `cyclonedds/bad-unit`.

## Why it matters on a robot
`<LeaseDuration>10</LeaseDuration>` is a lease of 10 ms: participants lose each other all the time. For sizes
the library only prints a warning at every start of every process.

## Bad
```xml
<LeaseDuration>10</LeaseDuration>
```

## Good
```xml
<LeaseDuration>10s</LeaseDuration>
```

## When to ignore it
If the number really is meant in bytes or milliseconds, and you accept the warning at every start.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
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
        value = remark.word
        plain = value.strip().isdecimal()
        if unit == "B":
            message = f"{remark.known.name} {value} is read as {value} bytes, with a warning at every start"
        else:
            message = f"{remark.known.name} {value} is read as {value} {unit}, not seconds"
        yield finding(
            value,
            message,
            advice=f"write the unit: {value}{unit}",
            severity="info" if unit == "B" else None,
            fix=fix(f"append {unit}", (value, f"{value}{unit}")) if plain else None,
        )
