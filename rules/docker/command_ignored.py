"""The entrypoint never runs the command that it is given.

## What it finds
A CMD after an ENTRYPOINT, or a `command:` of a compose service, that the entrypoint drops: the entrypoint is in shell
form, or it is a script of the tree that reads none of its arguments (`$@`, `$*`, `$1`...). An info where the entrypoint
runs the same command itself.

## Why it matters on a robot
Docker hands the command to the entrypoint as arguments. A script that does not look at them does what it always does,
often an idle shell, and the launch that the container is for never starts.

## Bad
```dockerfile
ENTRYPOINT ["/entrypoint.sh"]            # ends in: source /opt/ros/jazzy/setup.bash
CMD ["ros2", "launch", "base", "base.launch.py"]
```

## Good
```sh
# the last line of entrypoint.sh
exec "$@"
```

## When to ignore it
When the words are only there for people who read the file.

## References
- https://docs.docker.com/reference/dockerfile/#understand-how-cmd-and-entrypoint-interact
- https://docs.docker.com/reference/compose-file/services/#command
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner
from bringup_lint.api.shell import unwrapped

READS_ARGUMENTS = regex(r"\$(?:[@*#0-9]|\{[@*#0-9!]|\{?BASH_ARG)|\bshift\b|\bgetopts?\b|\bfor\s+\w+\s*(?:;|\n|\bdo\b)")


WORD = regex(r"[^\s\",\[\]]+")


class Dropped(NamedTuple):
    command: Located | Span
    entrypoint: Located | Span
    why: str


@rule("error", silent="the entrypoint runs, and the command is dropped without a message")
def command_ignored(robot: Robot) -> Iterator[Finding]:
    seen: set[Span] = set()
    for runner in robot.runners.in_containers:
        dropped = _dropped(runner)
        if dropped is None or _span(dropped.command) in seen:
            continue
        seen.add(_span(dropped.command))
        yield finding(
            dropped.command,
            f"{dropped.why}: this command never runs in {runner.name}",
            advice='end the entrypoint with exec "$@"',
            related=[note(dropped.entrypoint, "the entrypoint")],
            severity="info" if _runs_the_same(runner, dropped) else None,
        )


def _span(place: Located | Span) -> Span:
    return place.span if isinstance(place, Located) else place


def _runs_the_same(runner: Runner, dropped: Dropped) -> bool:
    """Whether the entrypoint runs the very command that it drops, so that nothing is lost."""
    service = runner.service
    if service is not None and service.command:
        words = [str(word) for word in service.command]
    else:
        words = WORD.findall(str(dropped.command))
    steps = (step for line in runner.main for step in line.steps)
    return any(words == [str(word) for word in unwrapped(step.command.words)] for step in steps)


def _dropped(runner: Runner) -> Dropped | None:
    entrypoint, command = _of_service(runner) or _of_image(runner) or (None, None)
    if entrypoint is None or command is None:
        return None
    if isinstance(entrypoint, Located) and not entrypoint.startswith("["):
        return Dropped(command, entrypoint, "The entrypoint is in shell form and takes no arguments")
    for line in runner.main:
        program = next(iter(unwrapped(line.argv)), None)
        if program is None or not _is_part(program, entrypoint):
            continue
        script = runner.reads(str(program))
        if script is not None and script.text.startswith("#!") and not READS_ARGUMENTS.search(script.text):
            return Dropped(command, entrypoint, f"{script.basename} reads none of its arguments")
    return None


def _is_part(program: Located, entrypoint: Located | Span) -> bool:
    """Whether the entrypoint names the program: after ``tini --`` comes that of the command, which does run."""
    whole = _span(entrypoint)
    return program.span.source is whole.source and whole.start <= program.span.start < max(whole.end, whole.start + 1)


def _of_service(runner: Runner) -> tuple[Located | Span, Located | Span] | None:
    """The entrypoint and the command of a compose service that has a command of its own."""
    service, stage = runner.service, runner.stage
    if service is None or not service.command:
        return None
    if service.entrypoint:
        return service.entrypoint[0].span, service.command[0]
    instruction = stage.last("ENTRYPOINT") if stage is not None else None
    return (instruction.value, service.command[0]) if instruction is not None else None


def _of_image(runner: Runner) -> tuple[Located, Located] | None:
    """ENTRYPOINT and CMD of an image; an ENTRYPOINT takes the CMD of the image below away."""
    service = runner.service
    if runner.stage is None or (service is not None and (service.command or service.entrypoint)):
        return None
    commands: list[Located] = []
    for stage in runner.stage.chain:
        commands = commands or [each.value for each in stage.all("CMD")]
        entrypoints = [each.value for each in stage.all("ENTRYPOINT")]
        if entrypoints:
            return (entrypoints[-1], commands[-1]) if commands else None
    return None
