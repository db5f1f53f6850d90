"""A node opens a file in the home folder of a person.

## What it finds
In Python nodes, two kinds of files below `/home/<user>/`:

- `open()`, `cv2.imread()`, `YOLO()`, `numpy.load()` and the like of a file in a home of which nothing else in the tree
  knows: no unit, script, image or playbook names the user.
- The same, and defaults of `declare_parameter()`, with a path into a package of the tree that has no such file, also
  where the user is known. Models, maps and logs, which are made on the robot, are left out.

Silent where the exception is handled, below a condition, and where a launch or parameter file gives the parameter.

## Why it matters on a robot
The path exists on the computer of the developer. On every other one `open()` raises FileNotFoundError, and the node
ends at its start, or in the middle of a drive when only a callback opens the file.

## Bad
```python
with open('/home/anna/crane_ws/src/crane/config/camera.json') as file:
```

## Good
```python
with open(os.path.join(get_package_share_directory('crane'), 'config', 'camera.json')) as file:
```

## When to ignore it
When every robot has this user and the file.

## References
- https://docs.ros.org/en/jazzy/How-To-Guides/Package-maintainer-guide.html
- ament_index_python, get_package_share_directory
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("warning", confidence="medium", symptoms=["FileNotFoundError: [Errno 2] No such file or directory: '/home/"])
def home_path(robot: Robot) -> Iterator[Finding]:
    for found in nodes.home_files(robot.nodes):
        idle = found.idle or nodes.is_tool(robot.nodes, found.file)
        message = f"{found.call}() needs a file in {found.home}, which nothing else in the tree knows: on another "
        message += f"computer it raises, and {nodes.end_of(robot.nodes.syntax(found.file), found.place)}"
        if found.missing:
            message = f"{found.path} is not there: the tree has no {found.missing}"
        yield finding(
            found.file.span_of(found.place),
            message,
            advice="install the file with its package, and find it with get_package_share_directory()",
            severity="info" if idle else robot.nodes.lowered(found.file.source, "warning"),
        )
