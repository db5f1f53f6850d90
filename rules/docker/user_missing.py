"""A container is to run as a user that its image does not have.

## What it finds
A name in `USER` of a Dockerfile, in `user:` of a compose service and in `remoteUser` or `containerUser` of a
`devcontainer.json`, where the Dockerfile names an official image of Ubuntu, Debian, ROS or CUDA in plain words, and
its steps only do what certainly makes no user: they build, and install packages of ROS, of Python and a few tools.

Silent for numbers and variables, where a step has the name, where one runs any other program or copies files to `/` or
`/etc`, where compose gives a service `configs`, `secrets` or files of `/etc`, or a build `additional_contexts`, and
where a development container has features or its own `/etc`.

## Why it matters on a robot
Docker looks the name up in `/etc/passwd` of the image. It is not there: the next step of the build fails, the
container does not start, and an editor cannot get into the development container.

## Bad
```dockerfile
FROM ros:jazzy
USER rover
CMD ["ros2", "launch", "rover_base", "base.launch.py"]
```

## Good
```dockerfile
FROM ros:jazzy
RUN useradd --create-home rover
USER rover
CMD ["ros2", "launch", "rover_base", "base.launch.py"]
```

## When to ignore it
When something mounts an `/etc/passwd` with this user.

## References
- https://docs.docker.com/reference/dockerfile/#user
- https://containers.dev/implementors/json_reference/, "remoteUser"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import missing_users

EFFECTS = {"dockerfile": "the image cannot be built or run", "compose": "the container does not start"}


@rule("warning", symptoms=["unable to find user *: no matching entries in passwd file"])
def user_missing(robot: Robot) -> Iterator[Finding]:
    for missing in missing_users(robot.files, robot.compose):
        kind = missing.where.span.source.kind
        yield finding(
            missing.where,
            f"Nothing makes the user {missing.name} in this image: "
            + EFFECTS.get(kind, "the editor cannot open the container"),
            advice="add useradd to the Dockerfile, or name a user that the image has",
            related=[]
            if missing.image is None
            else [note(missing.image, "has no such user, nor do the steps make it")],
        )
