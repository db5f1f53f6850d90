"""A Cyclone DDS name is shortened.

## What it finds
A name that is only the beginning of the real one, such as `addr` for `Address`:
- **error**: in a file, where the library does not accept shortened names.
- **info**: in XML that is given inline in `CYCLONEDDS_URI`, where it accepts them if they are unique.

## Why it matters on a robot
In a file the library does not know the shortened name: no participant is created and no ROS node starts.
Inline, the name works until another one starts with the same letters.

## Bad
```xml
<Peer addr="10.0.0.10"/>
```

## Good
```xml
<Peer Address="10.0.0.10"/>
```

## When to ignore it
Inline, if the robot stays on one version of the library. In a file never.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import can_be_renamed
from bringup_lint.api.dds import renamed
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import Remark


@rule("error", fix="safe", symptoms=["unknown element", "unknown attribute", "ambiguous"])
def abbreviated_name(robot: Robot) -> Iterator[Finding]:
    for configuration, remark in robot.dds.remarks(Code.ABBREVIATED):
        if remark.fatal:
            message = f"'{remark.word}' is not a full name, and a file must not shorten names: no node starts"
        else:
            message = f"'{remark.word}' works only as long as no other name starts with it"
        yield finding(
            remark.word,
            message,
            advice=f"write {remark.detail}",
            severity=None if remark.fatal else "info",
            fix=_written_out(remark) if can_be_renamed(configuration, remark.word, remark.known) else None,
        )


def _written_out(remark: Remark) -> Fix:
    return fix(f"write {remark.detail}", *renamed(remark.word, remark.detail))
