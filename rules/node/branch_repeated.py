"""A branch of a C++ node has the condition of one before it, and never runs.

## What it finds
`else if` with a condition that an earlier `if` of the same chain has word for word. Conditions with calls or
assignments are left out: they may give another answer the second time.

## Why it matters on a robot
One of the two was meant to ask for something else. The case that it should handle is treated as the earlier one, or not
at all: an alert keeps the level of a worse one, a command of the remote control does nothing.

## Bad
```cpp
if (msg.level == Alert::HIGH) { stop(); }
else if (msg.level == Alert::HIGH) { slow_down(); }
```

## Good
```cpp
if (msg.level == Alert::HIGH) { stop(); }
else if (msg.level == Alert::LOW) { slow_down(); }
```

## When to ignore it
When another thread changes the value between the two questions, and that is meant.

## References
- C++ standard, [stmt.if]: the `else` branch runs when the condition is false
- CWE-561: dead code
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the branch is never reached, and the code compiles", tags=["CWE-561"])
def branch_repeated(robot: Robot) -> Iterator[Finding]:
    for each in nodes.repeated_branches(robot.nodes):
        yield finding(
            each.place,
            "This branch never runs: an earlier one has the same condition",
            advice="ask for what this branch is for, or remove it",
            related=[note(each.earlier, "takes all such cases")],
            severity=robot.nodes.lowered_if_vendored(each.place.source, "warning"),
        )
