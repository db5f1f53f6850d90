"""Two Fast DDS profiles or transports have the same name.

## What it finds
Two profiles of one kind with the same `profile_name` (`publisher` and `data_writer` are one kind), or
two transports with the same `transport_id`. A participant and a writer may share a name.

## Why it matters on a robot
The library keeps the first one and refuses the second with a line on the terminal: part of the file has no
effect.

## Bad
```xml
<participant profile_name="robot"/>
<participant profile_name="robot"/>
```

## Good
```xml
<participant profile_name="robot"/>
<participant profile_name="base"/>
```

## When to ignore it
Never: the second one has no effect. Delete it if the first one is right.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.fastdds import first_named
from bringup_lint.api.schema import Code


@rule("error", symptoms=["Error adding profile", "There is other transport with the same id"])
def duplicate_profile(robot: Robot) -> Iterator[Finding]:
    for profiles, remark in robot.dds.fastdds_remarks(Code.PROFILE_DUPLICATE, Code.TRANSPORT_DUPLICATE):
        kind = "transport" if remark.code == Code.TRANSPORT_DUPLICATE else remark.path.rpartition("/")[2]
        first = first_named(profiles, remark)
        yield finding(
            remark.where,
            f"A second {kind} is called '{remark.where}': it is refused, only the first one applies",
            advice="rename one of the two",
            related=[note(first, "the first one")] if first else (),
        )
