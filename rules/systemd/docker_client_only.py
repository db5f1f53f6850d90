"""A setting of a service reaches the Docker client, and not the container.

## What it finds
A service that runs `docker run` or `docker compose up`, and that sets one of these:

- limits, priorities, processors or memory (`LimitRTPRIO=`, `LimitMEMLOCK=`, `Nice=`, `CPUSchedulingPolicy=`,
  `CPUAffinity=`, `AllowedCPUs=`, `CPUQuota=`, `MemoryMax=`), where neither the command nor a compose file of the tree
  sets anything of the kind or makes a container privileged;
- a variable of ROS in `Environment=`, which `docker run` is not told to hand on by `--env` or `--env-file`, or which no
  compose file, environment file or Dockerfile of the tree names.

## Why it matters on a robot
The client only asks dockerd for the container. dockerd starts it in a cgroup of its own, with its own limits and with
the environment of the image: the control loop gets no real-time priority, or the nodes are in domain 0, and nothing
says so.

## Bad
```ini
[Service]
LimitRTPRIO=99
Environment=ROS_DOMAIN_ID=7
ExecStart=/usr/bin/docker run --rm --name arm rover/arm:1.2
```

## Good
```ini
[Service]
ExecStart=/usr/bin/docker run --rm --name arm --ulimit rtprio=99 --env ROS_DOMAIN_ID=7 rover/arm:1.2
```

## When to ignore it
When the image needs none of it, and the setting is for another command of the service.

## References
- https://docs.docker.com/reference/cli/docker/container/run/, "--ulimit", "--cpuset-cpus", "--memory" and "--env"
- systemd.exec(5), "Process Properties"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.ros import variables
from bringup_lint.api.systemd import DockerCommand
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import docker_starts

PRIORITY = regex(r"--(?:privileged|ulimit|cap-add|cpu-rt-\w+)|\b(?:privileged|ulimits|cap_add|cpu_rt_\w+)\b")
PROCESSORS = regex(r"--(?:cpus|cpuset-cpus|cpu-\w+)|-c\b|\b(?:cpus|cpuset|cpu_\w+|deploy)\b")
MEMORY = regex(r"--memory|-m\b|\b(?:mem_\w+|memswap_limit|deploy)\b")
KINDS = {
    "LimitRTPRIO": (PRIORITY, "--ulimit rtprio=", "ulimits"),
    "LimitMEMLOCK": (PRIORITY, "--ulimit memlock=", "ulimits"),
    "CPUSchedulingPolicy": (PRIORITY, "--cap-add SYS_NICE", "cap_add: [SYS_NICE]"),
    "CPUSchedulingPriority": (PRIORITY, "--cap-add SYS_NICE", "cap_add: [SYS_NICE]"),
    "Nice": (PRIORITY, "--cap-add SYS_NICE", "cap_add: [SYS_NICE]"),
    "CPUAffinity": (PROCESSORS, "--cpuset-cpus", "cpuset"),
    "AllowedCPUs": (PROCESSORS, "--cpuset-cpus", "cpuset"),
    "CPUQuota": (PROCESSORS, "--cpus", "cpus"),
    "MemoryMax": (MEMORY, "--memory", "mem_limit"),
}
"""Setting -> what does the same for the container, the option of docker run, and the key of a compose file."""
NAMED = ("compose", "env-file", "dockerfile")


@rule("warning", silent="dockerd starts the container without the setting")
def docker_client_only(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("docker"):
        starts = [start for process in robot.units.started(unit) for start in docker_starts(process)]
        if len(starts) != 1 or starts[0].verb == "start" or not unit.complete:
            continue
        lost = [*_settings(robot, unit, starts[0]), *_variables(robot, unit, starts[0])]
        if lost:
            (first, name, advice), *others = lost
            yield finding(
                first,
                f"{name} reaches the Docker client alone: dockerd starts the container of {unit.name} without it",
                advice=advice,
                related=[
                    note(starts[0].verb, "asks dockerd for the container"),
                    *(note(value, f"{other} does not reach it, either") for value, other, _ in others),
                ],
            )


def _settings(robot: Robot, unit: Unit, start: DockerCommand) -> Iterator[tuple[Located, str, str]]:
    for key, (own, option, field) in KINDS.items():
        value = unit.get(key)
        if value and not _says(robot, start, own):
            yield value, f"{key}=", f"set {field} in the compose file" if start.compose else f"pass {option}"


def _says(robot: Robot, start: DockerCommand, own: re.Pattern[str]) -> bool:
    """Whether something sets the same for the container, or may."""
    if start.compose:
        files = robot.of_kind("compose")
        return not files or any(own.search(each.text) for each in files)
    return any(own.match(word) for word in start.options)


def _variables(robot: Robot, unit: Unit, start: DockerCommand) -> Iterator[tuple[Located, str, str]]:
    for variable in robot.units.environment(unit):
        if variable.name not in variables() or variable.value.span.source.kind == "env-file":
            continue
        if not _is_handed_on(robot, start, variable.name):
            advice = (
                "name it below environment: in the compose file" if start.compose else f"pass --env {variable.name}"
            )
            yield variable.value, variable.name, advice


def _is_handed_on(robot: Robot, start: DockerCommand, name: str) -> bool:
    if start.compose:
        return not robot.of_kind("compose") or any(name in each.text for each in robot.of_kind(*NAMED))
    return any(word.startswith("--env-file") or name in word for word in (*start.options, start.process.line))
