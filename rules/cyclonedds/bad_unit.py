"""Cyclone DDS does not know a unit.

## What it finds
A size or duration with an unknown unit, or without one where the library requires it. Units are
case-sensitive:
- sizes: B, kB, KiB, MB, MiB, GB and GiB (all powers of 1024)
- durations: ns, us, ms, s, min, hr and day

## Why it matters on a robot
The library reports `unrecognised unit` or `unit is required` and creates no participant: no ROS node starts.

## Bad
```xml
<SocketReceiveBufferSize max="100KB"/>
```

## Good
```xml
<SocketReceiveBufferSize max="100kB"/>
```

## When to ignore it
Never: the library refuses the file, and no node starts.

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


@rule("error", fix="safe", symptoms=["unrecognised unit", "unit is required"])
def bad_unit(robot: Robot) -> Iterator[Finding]:
    sizes = ("B", "kB", "KiB", "MB", "MiB", "GB", "GiB")
    durations = ("ns", "us", "ms", "s", "min", "hr", "day")
    spelled = {
        "k": "kB",
        "m": "MB",
        "g": "GB",
        "kb": "kB",
        "sec": "s",
        "secs": "s",
        "seconds": "s",
        "h": "hr",
        "d": "day",
    }
    for _, remark in robot.dds.remarks(Code.UNIT):
        units = sizes if remark.known.type == "memsize" else durations
        value, unit = remark.word, remark.detail
        right = next((known for known in units if known.lower() == unit.lower()), None)
        guess = right or (spelled.get(unit.lower()) if spelled.get(unit.lower()) in units else None)
        end = len(value.rstrip())
        change = None
        if guess and unit and value[:end].endswith(unit):
            change = fix(f"write {guess}", (value.part(end - len(unit), end), guess), safe=bool(right))
        message = f"'{value}': unrecognised unit '{unit}'" if unit else f"{remark.known.name} '{value}' needs a unit"
        yield finding(
            value,
            f"{message}: no participant can be created, no node starts",
            advice=f"write {guess}" if guess else f"use one of {', '.join(units)}",
            fix=change,
        )
