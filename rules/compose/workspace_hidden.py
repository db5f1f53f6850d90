"""A bind mount hides the workspace that the image has built.

## What it finds
A service that mounts a folder of the host over the folder in which its Dockerfile runs `colcon build`, or over the
`install` below it, while its command or entry script sources that workspace, and nothing of what it runs builds it.
Silent where the folder of the tree holds an `install`, and for services in which somebody works.

## Why it matters on a robot
What the image has built is not there: the container sees the folder of the host, which has no `install` after a clone.
The start ends with "install/setup.bash: No such file or directory", until somebody builds on that robot by hand, and
from then on it runs that build, whatever image is pulled.

## Bad
```yaml
volumes:
  - .:/ws               # the Dockerfile has built /ws
command: bash -c "source /ws/install/setup.bash && ros2 launch base base.launch.py"
```

## Good
```yaml
volumes:
  - ./config:/ws/config
command: bash -c "source /ws/install/setup.bash && ros2 launch base base.launch.py"
```

## When to ignore it
When the workspace is always built in the mounted folder before the service starts.

## References
- https://docs.docker.com/engine/storage/bind-mounts/#bind-mounting-over-existing-data
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import hidden_workspaces
from bringup_lint.api.compose import is_workplace


@rule("warning", confidence="medium", silent="the shell only says that it finds no such file")
def workspace_hidden(robot: Robot) -> Iterator[Finding]:
    for hidden in hidden_workspaces(robot.files, robot.runners.all):
        if is_workplace(robot.compose, hidden.service):
            continue
        yield finding(
            hidden.volume.where,
            f"The folder of the host hides {hidden.folder}, which the image has built: '{hidden.service.name}' finds no"
            " install there",
            advice="mount only the folders that change, such as the configuration",
            related=[note(hidden.build, "built here, in the image"), note(hidden.sourced, "sourced from there")],
        )
