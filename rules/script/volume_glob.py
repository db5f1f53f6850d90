"""A volume of docker run has a pattern in its path, or an empty part.

## What it finds
`-v /dev/*:/dev/*` and the like: a `*` in the source of `-v` or `--volume` of `docker run` or `docker create`, in
scripts and in the commands of units. It is info for devices of a `--privileged` container, which has them all.

Also a colon at the end of the value of these options, and two of them in a row.

## Why it matters on a robot
Neither the shell nor Docker expands the pattern: no file is called `/dev/*:/dev/*`, and Docker takes the word as it is.
It makes an empty folder with the name `*` on the host and mounts that: no device is in the container. An empty part
between or after colons is an error of docker: the container is not started.

## Bad
```sh
docker run -v /dev/*:/dev/* rover/base:1.2
```

## Good
```sh
docker run --device /dev/rover/imu:/dev/imu rover/base:1.2
```

## When to ignore it
When a folder is called `*`.

## References
- https://docs.docker.com/engine/storage/bind-mounts/
"""

from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.shell import unwrapped

CLIENTS = ("docker", "podman", "nvidia-docker")


@rule("error", symptoms=["includes invalid characters for a local volume name", "empty section between colons"])
def volume_glob(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold(*CLIENTS):
        return
    found = {volume.span: (volume, words) for words in _commands(robot) for volume in _volumes(words)}
    for volume, words in found.values():
        source = volume.partition(":")[0]
        if source.startswith("/") and "*" in source and ":" in volume:
            yield finding(
                volume,
                f"Nothing expands '{source}': Docker mounts an empty folder of that name",
                advice="name each device with --device, or mount the folder",
                severity="info" if "--privileged" in words and source.startswith("/dev/") else None,
            )
        elif (volume.endswith(":") or "::" in volume) and "docker" in words[0]:
            place = "after the last colon" if volume.endswith(":") else "between two colons"
            yield finding(
                volume,
                f"There is nothing {place}: docker refuses the volume, and starts no container",
                advice="remove the colon, or write :ro",
            )


def _commands(robot: Robot) -> Iterator[tuple[Located, ...]]:
    for _, run in robot.scripts.run(*CLIENTS):
        yield run.words
    for runner in robot.runners.all:
        if runner.unit is not None:
            yield from (unwrapped(command.words) for command in runner.commands)


def _volumes(words: tuple[Located, ...]) -> Iterator[Located]:
    """The volumes that a client is told to mount."""
    if not words or words[0].rpartition("/")[2] not in CLIENTS or not {"run", "create"} & set(map(str, words)):
        return
    for option, value in pairwise(words):
        if option in ("-v", "--volume"):
            yield value
    yield from (word.part(len("--volume="), len(word)) for word in words if word.startswith("--volume="))
