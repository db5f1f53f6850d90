"""A parameter holds a path in a home folder.

## What it finds
Values below `/home/<user>/` or `/root/`. Files and folders that begin with `~/` are info, because some nodes expand the
`~`, and so are folders into which a script, Makefile or Dockerfile of the tree puts something, and files that nothing
takes. Not reported: the working directory of a unit in this tree, examples, and test folders.

## Why it matters on a robot
The path exists only on the machine on which it was written. ROS does not expand `~` in parameters.

## Bad
```yaml
map_server:
  ros__parameters:
    yaml_filename: /home/anna/maps/hall.yaml
```

## Good
```yaml
map_server:
  ros__parameters:
    yaml_filename: /var/lib/robot/maps/hall.yaml
```

## When to ignore it
When every robot has this user and the file is installed there, or, for the info finding, when the node expands `~`
itself.

## References
- launch_ros, `ParameterFile(allow_substs=True)`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import CONTAINER_KINDS
from bringup_lint.api.docker import container_folders
from bringup_lint.api.docker import deploying
from bringup_lint.api.docker import is_deployed_to
from bringup_lint.api.docker import is_in_container
from bringup_lint.api.docker import own_homes
from bringup_lint.api.params import ParameterFile
from bringup_lint.api.templates import is_example

_HOME = regex(r"(?:file://)?(/home/[^/\s<>${}]+/|/root/)\S*\Z")
_TILDE = regex(r"~/\S+\.[A-Za-z0-9]{1,8}\Z")
_PATH_KEY = regex(r"(?:path|file|filename|dir|directory|folder)\Z")


@rule("warning", symptoms=["Failed processing YAML file /home/", "No such file or directory: '/home/"])
def absolute_home_path(robot: Robot) -> Iterator[Finding]:
    kept = (
        [str(value).rstrip("/") for unit in robot.units.judged if (value := unit.get("WorkingDirectory"))]
        if robot.of_kind("systemd-unit")
        else []
    )
    kept += container_folders(robot.of_kind(*CONTAINER_KINDS))
    own = own_homes(robot)
    deployed = deploying(robot.files)
    for file, parameter in robot.params.parameters:
        if is_example(file.source.name) or "/test" in f"/{file.source.name}":
            continue
        for item in robot.params.items(parameter):
            if item.type != "string":
                continue
            path = item.text.removeprefix("file://")
            if _HOME.match(item.text) and not is_in_container(path, kept):
                known = is_in_container(path, own) or is_deployed_to(path, deployed) or is_idle(robot, file)
                yield finding(
                    item.span,
                    f"The path of '{parameter.name}' is in a home folder: it exists only on that machine",
                    advice="use a folder of the robot, such as /var/lib, or a package's share folder with allow_substs",
                    severity="info" if known or robot.params.is_replaced(file, parameter) else None,
                )
            elif _TILDE.match(item.text) or (
                item.text.startswith("~/") and _PATH_KEY.search(str(parameter.key).lower())
            ):
                yield finding(
                    item.span,
                    f"ROS does not expand the ~ of '{parameter.name}': unless the node does, it looks for a folder "
                    "called '~'",
                    advice="write the full path, or $(env HOME) in a file that is loaded with allow_substs",
                    severity="info",
                )


def is_idle(robot: Robot, file: ParameterFile) -> bool:
    """Whether the tree has launch files, and nothing of it takes the parameter file."""
    return robot.has_launch_files and not robot.params.is_used(file)
