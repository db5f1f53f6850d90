"""A path exists on one machine only.

## What it finds
Literal paths below `/home`, `/root` or `/opt/ros/<distribution>` in parameters, arguments, commands, includes and
defaults. Info in packages of others that the tree only carries, and where a script or Dockerfile of the tree puts
something into the folder of this home.

## Why it matters on a robot
The path is right on the developer's machine. The robot has another user or distribution, and the file is missing
there.

## Bad
```python
parameters=['/home/alice/ws/src/my_robot/config/motors.yaml']
```

## Good
```python
parameters=[PathJoinSubstitution([FindPackageShare('my_robot'), 'config', 'motors.yaml'])]
```

## When to ignore it
When all robots are built from one image with this user and distribution. An upgrade of the distribution still
breaks a path below `/opt/ros`.

## References
- launch_ros, `FindPackageShare`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import CONTAINER_KINDS
from bringup_lint.api.docker import container_folders
from bringup_lint.api.docker import is_deployed_to
from bringup_lint.api.docker import is_in_container
from bringup_lint.api.docker import own_homes

PATH = regex(r"(?:^|(?<=[=: ,'\"]))/(?:home/[\w.-]+|root|opt/ros/(?!\$)\w+)/[\w./-]+")

PLACEHOLDERS = ("/home/livox/livox_test.lvx",)
"""Values that drivers ask for and use only to replay a recording: livox_ros_driver2 with ``data_src`` 0."""


@rule("warning", symptoms=["No such file or directory: '/home/"])
def hardcoded_path(robot: Robot) -> Iterator[Finding]:
    folders = container_folders(robot.of_kind(*CONTAINER_KINDS))
    own = own_homes(robot)
    scripts = [source.text for source in robot.of_kind("shell-script", "dockerfile") if source.judged]
    for file in robot.launch.judged:
        for action, _ in robot.launch.visited(file):
            for value in values(action):
                for each in launch.walk(value):
                    text = launch.literal(each)
                    match = PATH.search(text) if text else None
                    if text is None or match is None or match[0] in PLACEHOLDERS:
                        continue
                    if not is_in_container(match[0], folders):
                        known = robot.launch.workspace.is_vendored(file.source) or is_in_container(match[0], own)
                        known = known or is_deployed_to(match[0], scripts)
                        yield finding(
                            text.part(*match.span()),
                            f"{match[0]} exists only on one machine or distribution",
                            advice="find it through the package's share folder, or make it an argument without a "
                            "default",
                            severity="info" if known else None,
                        )


def values(action: launch.Action) -> Iterator[launch.Value]:
    if isinstance(action, launch.DeclareArgument):
        yield from filter(None, [action.default])
    elif isinstance(action, launch.Include):
        yield action.file
        yield from (value for _, value in action.arguments)
    elif isinstance(action, launch.Process):
        yield from (*action.cmd, *(value for _, value in action.additional_env))
        yield from (*getattr(action, "parameters", ()), *getattr(action, "arguments", ()))
        for component in getattr(action, "components", ()):
            yield from getattr(component, "parameters", ())
