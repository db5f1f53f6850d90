"""A container gets a fixed name and stays after its end, so that it can be started only once.

## What it finds
`docker run --name` in the ExecStart= of a service and in scripts, without `--rm`, where nothing removes or starts the
container of that name again: no `docker rm`, `docker start` or `prune` in the script or unit, and none with that name
in another script. Silent for names that change, for scripts that look which containers exist, and for a script that
hands the container over to Docker with `--restart`.

## Why it matters on a robot
Docker keeps a container that has ended, with its name. After the next boot, or when the driver is started again after a
crash, `docker run` ends with "The container name is already in use", and the robot's software does not start.

## Bad
```sh
docker run -d --network host --name lidar rover/lidar
```

## Good
```sh
docker rm -f lidar 2>/dev/null
docker run -d --network host --name lidar rover/lidar
```

## When to ignore it
When the script runs once in the life of the robot.

## References
- docker container run, `--name` and `--rm`
"""

from collections.abc import Callable
from collections.abc import Iterator
from collections.abc import Sequence
from functools import partial

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import program_name
from bringup_lint.api.shell import run_options
from bringup_lint.api.shell import shell_commands
from bringup_lint.api.shell import unwrapped
from bringup_lint.api.systemd import Unit

CLIENTS = ("docker", "podman", "nvidia-docker")
KNOWS = regex(
    r"\b(?:docker|podman)[ \t]+(?:(?:container|system)[ \t]+)?(?:rm|start|restart|prune|ps|inspect|ls)\b",
    hints="docker podman",
)
"""Commands of a script that knows of containers of its last run."""
NAMED = regex(r"--name\b", hints="--name")
NAME = regex(r"[a-zA-Z0-9][\w.-]*")


class Start(NamedTuple):
    """A container that is made with a name."""

    verb: Located
    name: Located
    known: str
    """The name, without variables."""
    restarts: bool
    """The Docker daemon starts it again."""


@rule("warning", symptoms=["The container name * is already in use by container"])
def container_name_taken(robot: Robot) -> Iterator[Finding]:
    if not robot.mentions(NAMED):
        return
    known = _known_names(robot)
    for unit in robot.units.services:
        for start in _of_unit(robot, unit):
            if start.known not in known:
                yield _report(start, f"the second start of {unit.name} fails", "error")
    for source, started in _by_script(robot).items():
        if not _knows_containers(source):
            for start in started:
                if not start.restarts and start.known not in known:
                    yield _report(start, "the second run of this script fails", "warning")


def _report(start: Start, outcome: str, severity: str) -> Finding:
    return finding(
        start.verb,
        f"Docker keeps the container {start.known} after its end: {outcome} with 'name is already in use'",
        advice=f"add --rm, or remove the old one before: docker rm -f {start.known}",
        severity=severity,
        related=[note(start.name, "its name")],
    )


def _of_unit(robot: Robot, unit: Unit) -> list[Start]:
    """The containers that a service makes itself and leaves behind."""
    processes = robot.units.processes(unit)
    if any(KNOWS.search(text) for process in processes for text in process.texts):
        return []
    started = [process for process in processes if process.key == "ExecStart"]
    steps = [step for process in started for step in process.steps if step.script is None]
    found = (_start(unwrapped(step.command.words), str, lambda option: True) for step in steps)
    return [start for start in found if start is not None]


def _by_script(robot: Robot) -> dict[Source, list[Start]]:
    found: dict[Source, list[Start]] = {}
    for source, run in robot.scripts.run(*CLIENTS):
        start = _start(run.words, run.text, partial(_may_remove, source))
        if start is not None:
            found.setdefault(source, []).append(start)
    return found


def _start(words: Sequence[Located], text: Callable[[Located], str], may_remove: Callable[[str], bool]) -> Start | None:
    """What `docker run` makes and keeps, where its name is known."""
    if len(words) < 2 or program_name(words[0]) not in CLIENTS or words[1] not in ("run", "create"):
        return None
    given = {option.name: option.value for option in run_options(words[2:])}
    name = given.get("--name")
    if name is None or not NAME.fullmatch(text(name)) or any(_removes(option, may_remove) for option in given):
        return None
    restarts = given.get("--restart", "no") != "no"
    return Start(words[1], name, text(name), restarts)


def _removes(option: str, may_remove: Callable[[str], bool]) -> bool:
    """Whether an option removes the container, at its end or before the next one."""
    return option in ("--rm", "--replace") or (option.startswith("$") and may_remove(option))


def _may_remove(source: Source, option: str) -> bool:
    """Whether a variable among the options may hold `--rm`."""
    name = option.strip("${}")
    values = [text for command in shell_commands(source) for text in command.assignments]
    return not any(text.startswith(f"{name}=") for text in values) or any("--rm" in text for text in values)


def _known_names(robot: Robot) -> set[str]:
    """The words of all scripts and command lines that remove, start or look for containers."""
    processes = (process for unit in robot.units.services for process in robot.units.processes(unit))
    texts = [str(process.line) for process in processes if KNOWS.search(process.line)]
    texts += [script.text for script in robot.of_kind("shell-script") if _knows_containers(script)]
    return {word for text in texts for word in NAME.findall(text)}


def _knows_containers(source: Source) -> bool:
    """Whether a script removes, starts or looks for containers."""
    if not KNOWS.search(source.text):
        return False
    return any(KNOWS.search(" ".join((*each.words, *each.assignments))) for each in shell_commands(source))
