"""A container starts ros2 without sourcing ROS.

## What it finds
An image or a compose service whose first process is `ros2`, or a shell that runs it, where nothing sources a setup file
and nothing sets `PATH` or `AMENT_PREFIX_PATH`: an ENTRYPOINT, or `entrypoint:`, replaces the `/ros_entrypoint.sh` of an
official ROS image, or packages of ROS are installed on an image of Ubuntu, of CUDA or for Jetson, which has no
entrypoint.

Silent for entry scripts that are not in the tree, and for shells that read their profiles (`bash -l`, `bash -i`).

## Why it matters on a robot
Without `/ros_entrypoint.sh` the environment is empty: `ros2` is not in `PATH`, and the container ends at once.

## Bad
```dockerfile
FROM ros:jazzy
ENTRYPOINT ["ros2", "launch", "base", "base.launch.py"]
```

## Good
```dockerfile
FROM ros:jazzy
ENTRYPOINT ["/ros_entrypoint.sh", "ros2", "launch", "base", "base.launch.py"]
```

## When to ignore it
When the runtime sets the complete ROS environment, for example through an env file of the compose service.

## References
- docker-library ros image, ros_entrypoint.sh
- https://docs.docker.com/reference/compose-file/services/#entrypoint
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner
from bringup_lint.api.docker import distro_of
from bringup_lint.api.docker import ros_distro
from bringup_lint.api.systemd import Ros

INITS = ("tini", "dumb-init", "catatonit", "env")
"""Programs that start the words after them as they are."""
READS_PROFILES = regex(r"[\"']-\w*[il]\w*[\"']")
"""A SHELL that reads the profiles of its user."""
SETS = ("PATH", "AMENT_PREFIX_PATH", "BASH_ENV", "ENV")


@rule("error", symptoms=['exec: "ros2": executable file not found in $PATH', "ros2: not found"])
def entrypoint_bypass(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for runner in robot.runners.in_containers:
        ros = _unsourced(runner) if _starts_bare(runner) else None
        if ros is not None and ros.program.span not in seen:
            seen.add(ros.program.span)
            yield finding(
                ros.program,
                f"Nothing sources ROS before this in {runner.name}: ros2 is not found, and the container ends",
                advice='put "/ros_entrypoint.sh" first, or source /opt/ros/<distro>/setup.bash in the same shell',
                related=[note(runner.where, "starts it")] if runner.where.source is not ros.program.span.source else (),
            )


def _starts_bare(runner: Runner) -> bool:
    """Whether an image with ROS starts its first process without the entrypoint of the official images."""
    stage, service = runner.stage, runner.service
    if stage is not None and any(READS_PROFILES.search(each.value) for one in stage.chain for each in one.all("SHELL")):
        return False
    own = service is not None and service.key("entrypoint") is not None
    if stage is None:
        return own and service is not None and service.build is None and bool(ros_distro(service.image or ""))
    replaced = own or stage.last("ENTRYPOINT") is not None
    official = bool(ros_distro(stage.origin))
    return (official and replaced) or (not official and bool(distro_of(stage)))


def _unsourced(runner: Runner) -> Ros | None:
    """The first ``ros2`` of a container of which all that runs before it is known."""
    if any(runner.environment.defines(name) is not False for name in SETS):
        return None
    for line in runner.main:
        sources = any(step.command.name in ("source", ".", "eval") for step in line.steps)
        handed = line.line is not line.argv[0] and line.line.rpartition("/")[2] not in INITS
        if handed or line.opaque or sources or line.profiles:
            continue
        for step, ros in line.ros:
            if str(ros.program) == "ros2" and not step.command.depth:
                return ros
    return None
