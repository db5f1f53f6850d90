"""An attribute of an XML or YAML launch file has a value that launch cannot convert.

## What it finds
Texts where launch needs a number or a truth value at load time (`period`, `respawn_delay`, `prepend`), parameters whose
value is not of their `type`, lists of several types, commands with an open quote, and in YAML values that are not
of the type (`period: 3` is a whole number where a number with a decimal point is needed).

## Why it matters on a robot
`ros2 launch` stops before it starts a single node. A unit that runs it fails at every boot.

## Bad
```xml
<timer period="soon"/>
```

## Good
```xml
<timer period="3.0"/>
```

## When to ignore it
Only for a file that is not launched, such as a template that a generator fills in.

## References
- ros2/launch, `launch.utilities.type_utils`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.launch import refused


@rule(
    "error",
    symptoms=[
        "could not convert string to float",
        "expected to be of type",
        "non-uniform list",
        "Attribute respawn_delay of Entity * expected to be a non-negative value",
        "Attribute sigterm_timeout of Entity * expected to be a non-negative value",
        "Attribute on_exit of Entity * expected to be",
    ],
)
def invalid_value(robot: Robot) -> Iterator[Finding]:
    yield from refused(robot.launch, "value", "write a value of this type")
