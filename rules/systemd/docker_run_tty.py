"""A service asks Docker for a terminal that it does not have.

## What it finds
`docker run -it` and `docker exec -it`, with both letters and without `-d`, in a command of a service or in a script
that it starts. Services with StandardInput=tty are exempt.

## Why it matters on a robot
A service has no terminal. Docker ends at once with "the input device is not a TTY", so the container never starts at
boot, although the same line works when somebody types it.

## Bad
```ini
[Service]
ExecStart=/usr/bin/docker run -it --rm --name base rover/base:1.2
```

## Good
```ini
[Service]
ExecStart=/usr/bin/docker run --rm --name base rover/base:1.2
```

## When to ignore it
When the program gives itself a terminal.

## References
- https://docs.docker.com/reference/cli/docker/container/run/#tty
- systemd.exec(5), StandardInput=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.systemd import Step

INSIDE = ("ros2", "bash", "sh", "/bin/bash", "/bin/sh", "-c")


@rule("error", symptoms=["the input device is not a TTY", "cannot attach stdin to a TTY-enabled container"])
def docker_run_tty(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("docker"):
        if unit.has("StandardInput"):
            continue
        for process in robot.units.processes(unit):
            for step in process.steps:
                terminal = _terminal(step)
                if terminal is not None:
                    yield finding(
                        terminal,
                        f"{unit.name} has no terminal: Docker ends with 'the input device is not a TTY'",
                        advice="leave out -i and -t",
                        related=[note(process.program, f"{unit.name} starts it here")] if step.script else (),
                    )


def _terminal(step: Step) -> Located | None:
    """The option by which Docker asks for a terminal."""
    words = unwrapped(step.command.words)
    if step.command.depth or len(words) < 3 or program_name(words[0]) not in ("docker", "nvidia-docker"):
        return None
    if words[1] not in ("run", "exec"):
        return None
    cut = next((at for at, word in enumerate(words) if word in INSIDE), len(words))
    options = words[2:cut]
    detached = any(word == "--detach" or (_is_group(word) and "d" in word) for word in options)
    pairs = zip(options, (*options[1:], ""), strict=True)
    return None if detached else next((word for word, after in pairs if _asks(word, after)), None)


def _asks(word: str, after: str) -> bool:
    """Whether a word has both letters, or has one of them and the next word the other."""
    return (_is_group(word) and {"i", "t"} <= set(word)) or {word, after} == {"-i", "-t"}


def _is_group(word: str) -> bool:
    """Whether a word is a group of the switches -d, -i, -q and -t."""
    return len(word) > 1 and word[0] == "-" and set(word[1:]) <= set("diqt")
