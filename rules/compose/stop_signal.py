"""docker stop sends SIGTERM to ros2 launch.

## What it finds
A service that runs `ros2 launch` and is stopped by SIGTERM: it has no `stop_signal`, and its image has no
`STOPSIGNAL`. The image is known if it is an official one, or if a Dockerfile of the tree builds it, be it for another
service, in a bake file or in a script. Images from elsewhere are not reported; neither are those whose own CMD runs
`ros2 launch`: `docker/stopsignal` reports them. A launch that is typed into tmux or screen gets no signal of the
container, so that `stop_signal` does not help: it is not reported.

## Why it matters on a robot
On SIGTERM `ros2 launch` exits without stopping its nodes. Ten seconds later Docker kills everything that is left.
Drivers do not park their motors, and bags are not closed.

## Bad
```yaml
nav:
  command: ros2 launch nav nav.launch.py
```

## Good
```yaml
nav:
  command: ros2 launch nav nav.launch.py
  stop_signal: SIGINT
```

## When to ignore it
When a wrapper in the image translates SIGTERM into SIGINT.

## References
- https://github.com/ros2/launch/issues/666
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.yaml import last_key

LAUNCH = regex(r"\bros2[\s\",\[\]]+launch\b")


@rule("warning", fix="unsafe", symptoms=["exited with code 137"])
def stop_signal(robot: Robot) -> Iterator[Finding]:
    for service in robot.compose.whole_services:
        launch = service.launches
        runner = robot.runners.of_service(service)
        if launch is None or launch.span.start < service.body.span.start or runner is None:
            continue
        if service.scalar("stop_signal") is not None or runner.stop.signal not in ("SIGTERM", "TERM", "15"):
            continue
        if _said_in_dockerfile(runner.stage) or any(line.launches_in_terminal for line in runner.main):
            continue
        yield finding(
            launch,
            f"docker stop sends SIGTERM to '{service.name}': ros2 launch exits before its nodes, and Docker kills them",
            advice="add stop_signal: SIGINT",
            fix=fix("add stop_signal: SIGINT", last_key(service.body, "stop_signal: SIGINT")),
        )


def _said_in_dockerfile(stage: Stage | None) -> bool:
    """Whether the image itself runs ros2 launch, so that docker/stopsignal reports it."""
    starts = [stage.last("CMD"), stage.last("ENTRYPOINT")] if stage is not None else []
    return any(each is not None and LAUNCH.search(each.value) for each in starts)
