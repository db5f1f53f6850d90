"""Launch files include each other in a circle.

## What it finds
A launch file that, through its includes, comes back to itself.

## Why it matters on a robot
launch follows the includes for ever: it hangs, uses a whole core and starts nothing.

## Bad
```xml
<!-- base.launch.xml -->
<launch><include file="$(dirname)/sensors.launch.xml"/></launch>
<!-- sensors.launch.xml -->
<launch><include file="$(dirname)/base.launch.xml"/></launch>
```

## Good
```xml
<!-- base.launch.xml -->
<launch><include file="$(dirname)/sensors.launch.xml"/></launch>
<!-- sensors.launch.xml -->
<launch><node pkg="demo" exec="lidar"/></launch>
```

## References
- launch, `IncludeLaunchDescription.execute`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error")
def include_cycle(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for expansion in robot.launch.expansions:
        for include in expansion.cycle:
            steps = [span for span in include.chain if span not in seen]
            circle = frozenset(include.chain)
            if include.target is not expansion.entry or circle in seen:
                continue
            seen.add(circle)
            files = ", ".join(dict.fromkeys(span.path for span in include.chain))
            yield finding(
                include.action.file.span,
                f"This include comes back to {include.target.source.name}: launch hangs and starts nothing",
                advice="break the circle",
                chain=[note(span, "is included here") for span in steps],
                related=[note(include.chain[0], f"the circle: {files}")] if len(include.chain) > 1 else [],
                severity="warning" if include.conditions else None,
            )
