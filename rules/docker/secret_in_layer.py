"""A private key or build secret stays in a layer of the image.

## What it finds
COPY or ADD of a private SSH key (`id_rsa`, `id_ed25519`, ...) or of a whole `.ssh` folder into the final image, and a
RUN that copies a file from `/run/secrets` to another place and does not remove it in the same step.

## Why it matters on a robot
Everybody who can pull the image, or has a robot with it, can read the key: `docker save` shows every layer, also when a
later step deletes the file. A key for the repositories then opens all of them.

## Bad
```dockerfile
RUN --mount=type=secret,id=key cp /run/secrets/key /root/.ssh/id_ed25519
```

## Good
```dockerfile
RUN --mount=type=ssh git clone git@example.org:rover/driver.git
```

## When to ignore it
When the image never leaves the machine that built it.

## References
- https://docs.docker.com/build/building/secrets/
- CWE-522: Insufficiently Protected Credentials
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Stage
from bringup_lint.api.docker import commands_of_run
from bringup_lint.api.shell import Command

KEY = regex(r"(?:^|/)(?:id_(?:rsa|dsa|ecdsa|ed25519)\w*|\.ssh/?)$")
SECRET = regex(r"/run/secrets/\S+")
GONE = regex(r"/(?:tmp|run|dev/shm|var/tmp)/")


@rule("error", tags=["CWE-522", "CWE-538"])
def secret_in_layer(robot: Robot) -> Iterator[Finding]:
    for file in robot.dockerfiles:
        if file.final is None:
            continue
        for stage in file.final.chain:
            if stage.start.keyword.span.source is file.source:
                for word in (*_copied(stage), *_kept(stage)):
                    yield finding(
                        word,
                        f"'{word}' stays in a layer of the image: everybody who can pull it can read the secret",
                        advice="use RUN --mount=type=ssh, or --mount=type=secret without a copy, and change the secret",
                    )


def _copied(stage: Stage) -> Iterator[Located]:
    """The private keys that COPY and ADD take from the build context."""
    for instruction in stage.all("COPY", "ADD"):
        if instruction.exec_form is None and not any(flag.startswith("--from") for flag in instruction.flags):
            yield from (word for word in list(instruction.value.words())[:-1] if KEY.search(word))


def _kept(stage: Stage) -> Iterator[Located]:
    """The build secrets that a step writes to a place that stays."""
    for instruction in stage.all("RUN"):
        commands = list(commands_of_run(instruction))
        if not any(command.name in ("rm", "shred") for command in commands):
            yield from (word for command in commands for word in _written(command))


def _written(command: Command) -> Iterator[Located]:
    secrets = [word for word in command.words[1:] if SECRET.fullmatch(word)]
    if command.name in ("cp", "install", "mv") and secrets and not GONE.match(command.words[-1]):
        yield from secrets[:1]
    elif command.name in ("cat", "base64") and command.ends != "|" and secrets:
        targets = [redirect.target for redirect in command.redirects if redirect.writes and redirect.target]
        if any(target.startswith(("/", "~", "$")) and not GONE.match(target) for target in targets):
            yield from secrets[:1]
