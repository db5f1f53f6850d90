"""A launch file gives xacro an argument that the description does not declare.

## What it finds
`name:=value` after the file in `Command(['xacro ', file, ' name:=', value])`, where neither the file nor what it
includes has an `<xacro:arg>` of the name or uses `$(arg name)`. Silent when something that it includes is not in the
tree.

## Why it matters on a robot
xacro ignores the argument without a message, and the description keeps its default: mock hardware stays real hardware,
a prefix or a serial port is not applied.

## Bad
```python
Command(['xacro ', model, ' use_fake:=', fake])   # the file has <xacro:arg name="fake" default="false"/>
```

## Good
```python
Command(['xacro ', model, ' fake:=', fake])
```

## When to ignore it
When a file that is made later declares the argument.

## References
- xacro, `process_args` and `<xacro:arg>`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("warning", silent="xacro takes arguments that nothing declares without a message")
def xacro_arg_unknown(robot: Robot) -> Iterator[Finding]:
    for name, description, known in robot.plugins.unknown_arguments:
        near = nearest(name, known, 3)
        names = f"it declares {', '.join(known[:8])}" if known else "it declares none"
        yield finding(
            name,
            f"{description.basename} declares no argument '{name}': xacro ignores it, and the description keeps its "
            "defaults",
            advice=f"write {near[0]}" if len(near) == 1 else names,
            related=[note(description, "the description")],
        )
