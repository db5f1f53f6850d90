"""A Fast DDS transport is used before it is defined.

## What it finds
A `transport_id` in `userTransports` that no `transport_descriptor` before the participant defines. The order
matters: `transport_descriptors` must come first.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<participant ...><rtps><userTransports>
  <transport_id>lan</transport_id>
</userTransports></rtps></participant>
<transport_descriptors>...</transport_descriptors>
```

## Good
```xml
<transport_descriptors>...</transport_descriptors>
<participant ...>...</participant>
```

## When to ignore it
Never: the library ignores the whole file.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.fastdds import transport_named
from bringup_lint.api.schema import Code


@rule("error", symptoms=["Transport Node not found"])
def undefined_transport(robot: Robot) -> Iterator[Finding]:
    for profiles, remark in robot.dds.fastdds_remarks(Code.TRANSPORT_UNDEFINED):
        later = transport_named(profiles, remark.word)
        message = f"Transport '{remark.word}' is not defined"
        advice = "define it in transport_descriptors"
        if later is not None:
            message, advice = (
                f"Transport '{remark.word}' is defined after its use",
                "move transport_descriptors before the participant",
            )
        yield finding(
            remark.word,
            f"{message}: the whole file is ignored, the robot runs with defaults",
            advice=advice,
            related=[note(later, "defined here")] if later is not None else (),
        )
