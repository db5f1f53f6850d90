"""docker stop sends SIGTERM to ros2 launch.

## What it finds
An image whose CMD or ENTRYPOINT runs `ros2 launch` without `STOPSIGNAL SIGINT`. Silent if compose files of the tree
build the image and all of them set `stop_signal`, and where docker/shell-form-cmd reports that the signal reaches only
a shell. It is info for images that a robot hardly runs by themselves, such as a demonstration.

## Why it matters on a robot
On SIGTERM `ros2 launch` exits without stopping its nodes. Ten seconds later Docker kills everything that is left.
Drivers do not park their motors, and bags are not closed.

## Bad
```dockerfile
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## Good
```dockerfile
STOPSIGNAL SIGINT
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## When to ignore it
When the deployment always sets the stop signal, for example with `docker run --stop-signal SIGINT`.

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
from bringup_lint.api.docker import Runner
from bringup_lint.api.docker import is_deployed
from bringup_lint.api.docker import stays_in_shell

LAUNCH = regex(r"\bros2[\s\",\[\]]+launch\b")


@rule("warning", fix="unsafe", symptoms=["exited with code 137"])
def stopsignal(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        stage = file.final
        if stage is None:
            continue
        runs = next((i for i in (stage.last("CMD"), stage.last("ENTRYPOINT")) if i and LAUNCH.search(i.value)), None)
        if runs is None or stays_in_shell(stage, runs):
            continue
        runners = robot.runners.of_stage(stage)
        if runners and not any(map(_gets_sigterm, runners)):
            continue
        signal = stage.last("STOPSIGNAL")
        source, start = runs.keyword.span.source, runs.keyword.span.start
        here = (source.span(start, start), "STOPSIGNAL SIGINT\n")
        yield finding(
            runs.value,
            "docker stop sends SIGTERM: ros2 launch exits before its nodes, and Docker kills them",
            advice="add STOPSIGNAL SIGINT",
            fix=fix("add STOPSIGNAL SIGINT", here) if signal is None else None,
            severity=None if is_deployed(robot.compose, file) else "info",
            confidence=None if any(runner.stop.signal for runner in runners) else "medium",
        )


def _gets_sigterm(runner: Runner) -> bool:
    """Whether docker stop sends SIGTERM; of an image whose base is not known it is assumed."""
    service = runner.service
    if service is not None and service.scalar("stop_signal") is not None:
        return False
    return runner.stop.signal in (None, "SIGTERM", "TERM", "15")
