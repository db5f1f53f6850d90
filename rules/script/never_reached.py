"""What a script starts last waits for a program that does not end.

## What it finds
A program that runs until it is stopped, in the foreground of a script, with commands after it that start or set up
something: `ros2 launch` before another `ros2 launch` or `ros2 run`, and a server such as `roscore`, `zenohd`,
`MicroXRCEAgent`, `ds4drv` or `ros2 bag record` before anything that is no cleaning up. Silent under `timeout`, with
`--daemon`, and in scripts with a `trap`.

## Why it matters on a robot
The shell waits for the first program. The second launch file, the service that is enabled in the last lines or the
recording starts when somebody stops the first program, and on the robot nobody does: half of it is missing without an
error.

## Bad
```sh
ros2 launch rover base.launch.py
ros2 launch rover nav.launch.py
```

## Good
```sh
exec ros2 launch rover everything.launch.py
```

## When to ignore it
When the next command is to follow the end of the program, as in a sequence of experiments.

## References
- bash(1), "Lists": the shell waits for a command that no & ends
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

SERVERS = ("roscore", "zenohd", "MicroXRCEAgent", "micro-xrce-dds-agent", "ds4drv", "mosquitto", "rosbridge_websocket")
DETACHED = regex(r"--daemon|-d|-h|--help|--version|-V")
LIMITED = regex(r"(?:^|/)(?:timeout|nohup|setsid|tmux|screen|systemd-run|start-stop-daemon)$")
TRAP = regex(r"\btrap [\"'\w]", hints="trap")
SETS_UP = ("cp", "install", "systemctl", "apt", "apt-get", "pip", "pip3", "python3", "roslaunch", "rosrun", "docker")


@rule("warning", confidence="medium", silent="the script waits for the program as it is told")
def never_reached(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("shell-script"):
        if not source.judged or source.template or TRAP.search(source.text):
            continue
        found = _waiting(robot, source)
        if found is None:
            continue
        waits, after = found
        yield finding(
            waits.words[0],
            f"The script waits here until {_name(waits)} ends: what follows does not start",
            advice="start it last, or from a unit or launch file of its own",
            related=[note(after.words[0], "this is not reached before")],
        )


def _waiting(robot: Robot, source: Source) -> tuple[Run, Run] | None:
    """The first command that lasts before others that matter, with the first of these."""
    found = None
    behind: dict[bool, Run] = {}
    for run in reversed([did for did in robot.scripts.done(source) if isinstance(did, Run) and did.certain]):
        is_server = run.name in SERVERS
        if is_server in behind and _lasts(run):
            found = run, behind[is_server]
        behind |= {server: run for server in (True, False) if _matters(run, server)}
    return found


def _lasts(run: Run) -> bool:
    """Whether a command surely runs until somebody stops it."""
    if run.command.ends in ("&", "|", "||", "&&") or any(map(LIMITED.search, run.command.words)):
        return False
    if run.name in SERVERS:
        return not any(map(DETACHED.fullmatch, run.arguments))
    return run.name == "ros2" and (run.arguments[:1] == ["launch"] or run.arguments[:2] == ["bag", "record"])


def _matters(after: Run, server: bool) -> bool:
    """Whether a command is missed behind a server, or behind another program that lasts."""
    starts_ros = after.name == "ros2" and after.arguments[:1] in (["launch"], ["run"])
    return starts_ros or (server and after.name in SETS_UP)


def _name(run: Run) -> str:
    return " ".join([run.name, *run.arguments[:1]]) if run.name == "ros2" else run.name
