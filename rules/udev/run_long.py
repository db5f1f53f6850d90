"""A rule starts a long-running program.

## What it finds
`RUN` or `PROGRAM` with `ros2 launch`, `ros2 run`, `roslaunch`, a launch file, a `sleep` of 6 s or more,
`nohup`, `setsid`, a background process, or `systemd-run --scope`; also a shell script of the tree that always runs
`ros2 launch` itself, in a subshell or a function as well. Commands and scripts that hand work to systemd (`systemd-run`
without `--scope`, `systemctl --no-block`) are not reported, nor is what a script runs as another user with `su`, which
may open a session.

## Why it matters on a robot
When an event ends, at the latest after 180 s, udev kills everything that the event started, including
background processes. The driver dies seconds after the device appears.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", RUN+="/usr/local/bin/start.sh &"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{serial}=="A5XK3RJT", TAG+="systemd", ENV{SYSTEMD_WANTS}+="imu.service"
```

## When to ignore it
If the `sleep` waits for slow hardware to settle, stays well below 180 s and holds up nothing else: other
events of the device wait for it.

## References
- udev(7), RUN: "only be used for very short-running foreground tasks"
- systemd.device(5), SYSTEMD_WANTS=
"""

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Block
from bringup_lint.api.shell import Command
from bringup_lint.api.shell import shell_blocks

_LASTING = (
    (
        regex(r"\bros2\s+(?:launch|run)\b|\broslaunch\b|\brosrun\b|\S+\.launch(?:\.py|\.xml|\.yaml)?\b"),
        "a ROS program",
    ),
    (regex(r"\bnohup\b|\bsetsid\b|\bdisown\b"), "a detached process"),
    (regex(r"(?<!&)&\s*(?:['\"]?\s*)\Z"), "a background process"),
    (regex(r"\bsleep\s+(?:[1-9]\d+|[6-9])\b"), "a long sleep"),
    (regex(r"\bsystemd-run\b(?=.*--scope)"), "a systemd-run --scope command"),
)
_HANDED_OVER = regex(
    r"\bsystemd-run\b(?!.*--scope)|\bsystemctl\b.{0,400}--no-block|--no-block\b.{0,400}\bsystemctl\b|\bat\s+now\b"
)
_STARTS_ELSEWHERE = regex(
    r"\bsystemd-run\b|\bsystemctl\b[^\n]{0,200}\b(?:re)?start\b|\bat\s{1,4}now\b", hints="systemd-run systemctl now"
)
"""A script that may be meant to run again outside of udev, and launch ROS only there."""
_TESTS = ("[", "[[", "test")


@rule("warning", symptoms=["Spawned process", "timed out, killing", "is taking a long time"])
def run_long(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for command in line.commands:
            if _HANDED_OVER.search(command.text):
                continue
            for pattern, what in _LASTING:
                found = pattern.search(command.text)
                if found:
                    yield finding(
                        command.text.part(*found.span()),
                        f"udev kills {what} when the event that started it ends, at the latest after 180 s",
                        advice='start a unit instead: TAG+="systemd", ENV{SYSTEMD_WANTS}+="name.service"',
                    )
                    break
            else:
                yield from _of_script(robot, command.text)


def _of_script(robot: Robot, text: Located) -> Iterator[Finding]:
    """A script of the tree that the command runs, and that stays with ROS."""
    path = next(iter(text.split()), "")
    script = robot.find(path, text.span.source) if path.startswith("/") else None
    if script is None or script.kind != "shell-script" or _STARTS_ELSEWHERE.search(script.said):
        return
    for command in _always_run(shell_blocks(script), {}):
        words = command.words[1:] if command.name == "exec" else command.words
        if tuple(words[:2]) == ("ros2", "launch"):
            yield finding(
                text,
                "udev kills a ROS program when the event that started it ends, at the latest after 180 s",
                advice='start a unit instead: TAG+="systemd", ENV{SYSTEMD_WANTS}+="name.service"',
                related=[note(words[0], "the script stays with it here")],
            )
            return


def _always_run(found: Iterable[Block], functions: dict[str, Block]) -> Iterator[Command]:
    """The commands of statements that no condition holds back, with those of groups and of functions that are called,
    each once."""
    before: Command | None = None
    for block in found:
        is_tested = before is not None and before.name in _TESTS and before.ends in ("&&", "||")
        before = block.command
        if block.kind == "function":
            functions[block.name] = block
        elif block.kind == "group" and not is_tested:
            yield from _always_run(block.bodies[0], functions)
        elif block.command is not None and not is_tested:
            yield block.command
            called = functions.pop(block.command.name, None)
            if called is not None:
                yield from _always_run(called.bodies[0], functions)
