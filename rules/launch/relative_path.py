"""A launch file names a file relative to the working directory.

## What it finds
Parameter files and included launch files with a relative path that no package or substitution leads to, and other
files with one that exists in the package or above it, given to rviz2, map_server, robot_state_publisher and programs of
the tree that do not ask for the folder of a package themselves. Silent where the file lies beside the launch file, or
above the package and a unit, container or script chooses its working directory; and for launch files outside of
packages.

## Why it matters on a robot
The path counts from the folder in which `ros2 launch` was typed. Under systemd that is `/`: a node whose parameter
file is not found starts with the defaults of its code, with one warning in the log, and an include ends launch.

## Bad
```python
Node(package='my_robot', executable='driver', parameters=['config/driver.yaml'])
```

## Good
```python
Node(package='my_robot', executable='driver', parameters=[PathJoinSubstitution([share, 'config', 'driver.yaml'])])
```

## When to ignore it
When whatever starts the launch file changes to that folder before, and nothing else starts it.

## References
- launch_ros, `Node`: "Parameter file path is not a file"
- systemd.exec(5), `WorkingDirectory=`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.launch import relative_paths

EFFECTS = {
    "parameters": "the node starts with the defaults of its code",
    "include": "launch aborts",
    "path": "the file is not found",
}


@rule(
    "warning",
    confidence="medium",
    symptoms=["Parameter file path is not a file", "No such file or directory: 'config/"],
)
def relative_path(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for each in relative_paths(robot.launch, robot.files, file):
            yield finding(
                each.path,
                f"{each.path} counts from the folder in which ros2 launch runs, not from the package: "
                f"elsewhere, as under systemd, {EFFECTS[each.kind]}",
                advice="begin with the share folder of the package",
                chain=robot.provenance.chain_to(each.path, f"{each.path} is opened"),
            )
