"""A development container names something that does not exist.

## What it finds
The Dockerfile, build context or compose file of a `devcontainer.json` that the repository does not hold, and a
`service` that none of its compose files defines. Paths are relative to the folder of `devcontainer.json`. Paths with
variables and files that git ignores are not reported.

## Why it matters on a robot
The container cannot be built or started, so nobody can build and test the robot's software as its authors did. It
mostly shows that a Dockerfile or a service was moved or renamed, and that other references are out of date too.

## Bad
```json
{"build": {"dockerfile": "../docker/Dockerfile"}}
```

## Good
```json
{"build": {"dockerfile": "../Dockerfile", "context": ".."}}
```

## When to ignore it
When a step before the start puts the file there.

## References
- https://containers.dev/implementors/json_reference/
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.docker import broken_references


@rule("warning", symptoms=["has neither an image nor a build context specified", "no such service:"])
def devcontainer_reference(robot: Robot) -> Iterator[Finding]:
    for broken in broken_references(robot.files, robot.compose):
        if broken.what == "service":
            message = f"No compose file of this container defines the service '{broken.name}': it does not start"
        else:
            message = f"The {broken.what} '{broken.name}' does not exist: the container cannot be built"
        yield finding(
            broken.name,
            message,
            advice="paths are relative to the folder of devcontainer.json",
            related=[note(file, "the services of this file") for file in broken.files],
        )
