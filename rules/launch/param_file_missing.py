"""A parameter file does not exist.

## What it finds
Parameter files in the share folder of a workspace package, or beside the launch file, that are neither in the source
nor made by the build.

## Why it matters on a robot
launch logs a warning that scrolls by and starts the node without its parameters: the defaults of the code drive the
robot. With `allow_substs` or `RewrittenYaml` launch opens the file itself and aborts.

## Bad
```python
Node(package='my_robot', executable='driver', parameters=[PathJoinSubstitution([share, 'config', 'motor.yaml'])])
```

## Good
```python
Node(package='my_robot', executable='driver', parameters=[PathJoinSubstitution([share, 'config', 'motors.yaml'])])
```

## References
- launch_ros, `Node`: "Parameter file path is not a file"
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", symptoms=["Parameter file path is not a file", "Couldn't parse params file"])
def param_file_missing(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for reference in robot.launch.references(file):
            if reference.kind != "parameters" or reference.found.file is not None or not reference.name:
                continue
            package = reference.found.package
            near = nearest(reference.name, robot.launch.yaml_names(package), 3)
            effect = "launch aborts" if reference.aborts else "the node starts with the defaults of its code"
            yield finding(
                reference.span,
                f"{reference.name} does not exist in {package.name}: {effect}",
                advice=f"use {os.path.basename(near[0])}" if near else "correct the path",
                related=[note(package.manifest.name, f"the package {package.name}")],
                severity="warning" if reference.optional else None,
            )
