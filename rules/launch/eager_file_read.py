"""A file is read while the launch description is built.

## What it finds
`open()` and xacro calls (`xacro.process_file`, `xacro.process`) in the entry function, outside functions that
launch calls later.

## Why it matters on a robot
The file must exist before any argument is known. Without it even `ros2 launch --show-args` fails, and an argument
cannot select another file.

## Bad
```python
with open(urdf_path) as file:
    description = file.read()
```

## Good
```python
description = ParameterValue(Command(['xacro ', urdf_path]), value_type=str)
```

## When to ignore it
When the file is in the package's own share folder, is always installed with the launch file, and no argument
selects it.

## References
- launch, `Command` and `OpaqueFunction`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

READS = ("open", "xacro.process_file", "xacro.process")


@rule("info", symptoms=["FileNotFoundError"])
def eager_file_read(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for call in file.calls:
            if call.name in READS and not call.deferred:
                yield finding(
                    call.span,
                    f"{call.name}() reads a file while the description is built: --show-args fails when it is missing",
                    advice="use Command(['xacro ', path]), or read it in an OpaqueFunction",
                )
