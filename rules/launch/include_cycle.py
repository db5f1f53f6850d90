"""Launch files include each other in a cycle.

## What it finds
A launch file that includes itself, directly or through other files. An include under a condition is a warning.

## Why it matters on a robot
launch follows the includes forever. It hangs, uses a whole core and starts nothing.

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

## When to ignore it
Only when a condition is guaranteed to end the recursion, for example a counter that is passed as an argument.

## References
- launch, `IncludeLaunchDescription.execute`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["RecursionError: maximum recursion depth exceeded"])
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
                f"This include leads back to {include.target.source.name}: launch hangs and starts nothing",
                advice="break the cycle",
                chain=[note(span, "included here") for span in steps],
                related=[note(include.chain[0], f"the cycle: {files}")] if len(include.chain) > 1 else [],
                severity="warning" if include.conditions else None,
            )
