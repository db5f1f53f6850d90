"""A health check starts ros2 without its setup file.

## What it finds
A `healthcheck:` whose test starts `ros2` and sources no setup file, for a service whose image is built in the tree
(on an official image) or is an official image of ROS, and of whose variables none replaces the setup file.

## Why it matters on a robot
Docker runs the test beside the entrypoint, not through it: what the entrypoint sources is not there. `ros2` is not
found, the container is never healthy, and what waits for it with `service_healthy` never starts.

## Bad
```yaml
healthcheck:
  test: ["CMD-SHELL", "ros2 node list | grep -q base"]
```

## Good
```yaml
healthcheck:
  test: ["CMD", "/ros_entrypoint.sh", "bash", "-c", "ros2 node list | grep -q base"]
```

## When to ignore it
When something in the image that the tree does not show puts `ros2` and its packages into every shell.

## References
- https://docs.docker.com/reference/dockerfile/#healthcheck
- https://docs.docker.com/reference/compose-file/services/#healthcheck
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.compose import Service
from bringup_lint.api.docker import Runner
from bringup_lint.api.docker import has_dash
from bringup_lint.api.yaml import Mapping
from bringup_lint.api.yaml import Scalar
from bringup_lint.api.yaml import Sequence

BARE = regex(r"(?:^|[;&({]|-c[ \t]+(?![ \t])['\"]?)[ \t]*(?:(?:exec|timeout[ \t]+[\w.]+)[ \t]+)*ros2(?=[ \t]|$)")
MAY_SOURCE = regex(
    r"source|setup\.|entrypoint|AMENT|(?:^|[ \t;&])\.[ \t]|sh(?:[ \t]+-\w+){0,3}[ \t]+-\w*[il]|--login|exit[ \t]+0"
    r"|(?:\|\||;)[ \t]*(?:true|:)(?![\w.])|\|\|[ \t]*ros2"
)
SETS_UP = regex(r"bin/ros2\b|BASH_ENV|AMENT_PREFIX_PATH|SHELL[ \t]*\[[^\n\]]*-\w*[il]")
REPLACES = ("AMENT_PREFIX_PATH", "PATH", "BASH_ENV", "ENV")


@rule("error", confidence="medium", symptoms=["dependency failed to start: container * is unhealthy"])
def healthcheck_not_sourced(robot: Robot) -> Iterator[Finding]:
    for runner in robot.runners.all:
        service = runner.service
        is_own = service is not None and not robot.compose.is_set_elsewhere(service, "healthcheck")
        word = _test(service) if service is not None and is_own else None
        if word is not None and _has_no_ros(robot, runner):
            yield finding(
                word,
                "The health check does not go through the entrypoint: ros2 is not found, and the container is never "
                "healthy",
                advice="let the test source the setup file: bash -c 'source ... && ros2 ...'",
                related=[note(runner.where, "the service")],
            )


def _test(service: Service) -> Located | None:
    """The word of the test that starts ros2 without a setup file."""
    check = service.get("healthcheck")
    test = check.get("test") if isinstance(check, Mapping) and check.get("disable") is None else None
    if isinstance(test, Scalar):
        words = [test.value]
    elif isinstance(test, Sequence):
        words = [each.value for each in test.scalars][1:]
    else:
        return None
    if MAY_SOURCE.search(" ".join(words)):
        return None
    return next(
        (word for at, word in enumerate(words) if BARE.search(word) and (not at or words[at - 1] == "-c")), None
    )


def _has_no_ros(robot: Robot, runner: Runner) -> bool:
    """Whether the variables of the container surely come without a setup file."""
    stage = runner.stage
    if any(runner.environment.defines(name) is not False for name in REPLACES):
        return False
    if stage is None:
        return True
    text = "\n".join(str(each.value) for one in stage.chain for each in one.all("RUN", "ENV", "SHELL", "COPY"))
    return has_dash(stage.origin) and not SETS_UP.search(text) and not robot.compose.images.is_chosen(stage, tag=False)
