"""An argument of one include leaks into the next.

## What it finds
Two includes in the same scope whose files declare the same argument with different defaults. The second include
does not pass a value.

## Why it matters on a robot
launch has one scope for all included files. The default of the first file stays bound, and the second file never
uses its own: it silently loads the wrong parameters.

## Bad
```xml
<include file="$(dirname)/lidar.launch.xml"/>    <!-- declares params, default lidar.yaml -->
<include file="$(dirname)/camera.launch.xml"/>   <!-- declares params, default camera.yaml -->
```

## Good
```xml
<group><include file="$(dirname)/lidar.launch.xml"/></group>
<group><include file="$(dirname)/camera.launch.xml"/></group>
```

## When to ignore it
When the second file is meant to inherit the value of the first. Passing the argument explicitly says so and also
removes the finding.

## References
- launch, `GroupAction(scoped=True)`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def arg_leak(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.expansions:
        for declared in expansion.declared:
            before = declared.before
            if before is None or not before.declared or len(declared.chain) != 1 or declared.conditions:
                continue
            other = before.origin.source
            if other in (declared.file.source, expansion.entry.source) or declared.action.default is None:
                continue
            own = robot.launch.text(declared.action.default, declared.file)
            leaked = launch.text_of(before.value)
            if own is None or leaked is None or own.lower() == leaked.lower():
                continue
            yield finding(
                declared.chain[0],
                f"'{declared.name}' of {other.basename} leaks into this include: it gets '{leaked}', never its "
                f"default '{own}'",
                advice="pass the argument, or put each include into a scoped group",
                related=[
                    note(before.origin, "bound here first"),
                    note(declared.action.span, "this default is never used"),
                ],
            )
