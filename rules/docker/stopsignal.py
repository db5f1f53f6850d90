"""docker stop sends SIGTERM to ros2 launch.

## What it finds
An image whose CMD or ENTRYPOINT runs `ros2 launch` without `STOPSIGNAL SIGINT`. When compose files of the
tree build it and all of them set `stop_signal`, nothing is said.

## Why it matters on a robot
On SIGTERM `ros2 launch` ends without stopping its nodes; ten seconds later everything left is killed.
Drivers do not park motors, bags are not closed.

## Bad
```dockerfile
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## Good
```dockerfile
STOPSIGNAL SIGINT
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## References
- https://github.com/ros2/launch/issues/666
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

LAUNCH = re.compile(r"\bros2[\s\",\[\]]+launch\b")


@rule("warning", fix="safe", symptoms=["exited with code 137"])
def stopsignal(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        stage = file.final
        if stage is None or (stage.last("STOPSIGNAL") and stage.last("STOPSIGNAL").value in ("SIGINT", "2")):
            continue
        runs = next((i for i in (stage.last("CMD"), stage.last("ENTRYPOINT")) if i and LAUNCH.search(i.value)), None)
        services = [service for service in robot.compose.services if robot.compose.stage(service) is stage]
        if runs is None or (services and all(service.scalar("stop_signal") for service in services)):
            continue
        source, start = runs.keyword.span.source, runs.keyword.span.start
        here = (source.span(start, start), "STOPSIGNAL SIGINT\n")
        yield finding(
            runs.value,
            "docker stop sends SIGTERM: ros2 launch leaves its nodes, then everything is killed",
            advice="add STOPSIGNAL SIGINT",
            fix=fix("add STOPSIGNAL SIGINT", here) if stage.last("STOPSIGNAL") is None else None,
        )
