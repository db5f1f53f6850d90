"""An entry script takes the domain away that its container is given.

## What it finds
`export ROS_DOMAIN_ID=...` with a fixed value, in a script that an image or service has as its entrypoint and that ends
with `"$@"`. It is found when a service of the tree gives another value. In the entrypoint of an image it is an info
when the value is 0, which is the default of ROS 2 and so can only replace what is given. Silent when the script asks
first whether the variable is set.

## Why it matters on a robot
`environment:` and `docker run -e ROS_DOMAIN_ID=17` have no effect: all robots with this image share one domain, and
a command for one of them moves the others. `docker exec` does not run the entrypoint, so a shell in the container has
the other domain and sees no topics.

## Bad
```sh
export ROS_DOMAIN_ID=0
exec "$@"
```

## Good
```sh
export ROS_DOMAIN_ID="${ROS_DOMAIN_ID:-0}"
exec "$@"
```

## When to ignore it
When all machines with this image are to be in this domain whatever they are told.

## References
- ROS 2 documentation, "The ROS_DOMAIN_ID"
- https://docs.docker.com/reference/cli/docker/container/exec/
"""

from collections.abc import Iterator
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_commands

FIXED = regex(r"ROS_DOMAIN_ID=(\d+)")


@rule("warning", symptoms=["nodes do not see each other"], confidence="medium")
def ros_domain_id_overwritten(robot: Robot) -> Iterator[Finding]:
    for script, runners in _entry_scripts(robot).items():
        word = _fixed(list(shell_commands(script)))
        if word is None:
            continue
        value = word.partition("=")[2]
        given = [other for runner in runners if (other := _given(runner)) is not None and other != value]
        if given or (int(value) == 0 and any(map(_is_of_image, runners))):
            yield finding(
                word,
                f"{script.basename} sets domain {value}, whatever domain its container is given",
                advice=f'write export ROS_DOMAIN_ID="${{ROS_DOMAIN_ID:-{value}}}"',
                related=[
                    *(note(other, "has no effect") for other in given[:5]),
                    *(note(runner.where, f"{runner.name} starts the script") for runner in runners[:5]),
                ],
                severity=None if given else "info",
            )


def _entry_scripts(robot: Robot) -> dict[Source, list[Runner]]:
    """The scripts that run the command of their container, with what starts them."""
    found: dict[Source, list[Runner]] = {}
    for runner in robot.runners.in_containers:
        for script in {step.script: None for line in runner.main for step in line.steps}:
            if script is not None and script.judged and '"$@"' in script.said:
                found.setdefault(script, []).append(runner)
    return found


def _fixed(commands: list[Command]) -> Located | None:
    """The fixed domain that the script always exports before it runs its command."""
    for before, command in pairwise([Command(()), *commands]):
        if command.depth or before.ends in ("&&", "||"):
            continue
        if command.words[-1:] == ("$@",):
            return None
        if command.name == "export":
            for word in command.words[1:]:
                if FIXED.fullmatch(word):
                    return word
    return None


def _is_of_image(runner: Runner) -> bool:
    """Whether the script is the entrypoint of an image, which is run with any options."""
    return runner.stage is not None and (runner.service is None or not runner.service.entrypoint)


def _given(runner: Runner) -> Located | None:
    """What the service gives to its container."""
    variable = runner.service.environment.get("ROS_DOMAIN_ID") if runner.service is not None else None
    return variable.value if variable is not None else None
