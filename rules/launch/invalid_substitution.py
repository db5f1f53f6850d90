"""A substitution of an XML or YAML launch file cannot be parsed.

## What it finds
`$(...)` with a name that launch does not have or with the wrong number of arguments, one that is not closed, two
blanks between arguments, and arguments with quotes or parentheses inside that are not quoted as a whole.

## Why it matters on a robot
`ros2 launch` stops before it starts a single node. A unit that runs it fails at every boot.

## Bad
```xml
<node pkg="demo" exec="driver" namespace="$(var robot"/>
```

## Good
```xml
<node pkg="demo" exec="driver" namespace="$(var robot)"/>
```

## When to ignore it
When an extension of launch that is not in the tree defines the substitution.

## References
- ros2/launch, `launch.frontend.parse_substitution and grammar.lark`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.launch import refused


@rule(
    "error",
    fix="unsafe",
    symptoms=["Unknown substitution:", "substitution expects", "No terminal matches"],
)
def invalid_substitution(robot: Robot) -> Iterator[Finding]:
    yield from refused(robot.launch, "substitution", "correct the substitution")
