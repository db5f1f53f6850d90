"""A node opens a file of its package by a relative path.

## What it finds
In Python nodes of packages, calls that read a file (`open()`, `cv2.imread()`, `YOLO()`, `numpy.load()`, ...) by a
literal relative path, where the tree has the file beside the source or in a folder above it. Silent where the source
changes its folder, and where the file lies above the package and a unit, container or script chooses the working
directory.

## Why it matters on a robot
The path counts from the folder in which the program was started, not from that of the source. `ros2 run` and
`ros2 launch` leave it as it was in the shell, and under systemd it is `/`: the same program that works from the
workspace then finds no file. What is installed lies elsewhere anyway.

## Bad
```python
with open('src/rover/config/thrusters.csv') as table:
```

## Good
```python
path = os.path.join(get_package_share_directory('rover'), 'config', 'thrusters.csv')
with open(path) as table:
```

## When to ignore it
When whatever starts the node changes to that folder before, and nothing else starts it.

## References
- https://docs.python.org/3/library/functions.html#open: "relative to the current working directory"
- systemd.exec(5), `WorkingDirectory=`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    confidence="medium",
    symptoms=["No such file or directory: 'src/", "No such file or directory: 'install/"],
)
def relative_path(robot: Robot) -> Iterator[Finding]:
    for found, *others in nodes.relative_files(robot.nodes):
        idle = found.idle or nodes.is_tool(robot.nodes, found.file)
        yield finding(
            found.file.span_of(found.place),
            f"{found.call}() finds {found.path} only when the program is started in {found.folder}: "
            "elsewhere, as under systemd, it fails",
            advice="install the file, and begin with get_package_share_directory()",
            related=[note(each.file.span_of(each.place), f"{each.path} likewise") for each in others],
            severity="info" if idle else robot.nodes.lowered(found.file.source, "warning"),
        )
