"""ExecStop= only repeats what KillSignal= does.

## What it finds
ExecStop= that runs `kill` on $MAINPID and nothing else. A warning where it sends SIGINT, the main process is a shell
without a trap that starts `ros2 launch`, `ros2 run` or `ros2 bag record` as a child, and KillSignal= is another signal.
`ros2 bag record` closes its files on SIGTERM as well.

## Why it matters on a robot
`kill` returns at once, and systemd then sends KillSignal= anyway. ros2 launch ignores a second SIGINT. A
SIGTERM after the SIGINT makes it exit before its nodes have stopped. A shell that waits for a program does not pass
the signal on: the program never gets the SIGINT that ExecStop= is there for.

## Bad
```ini
[Service]
ExecStop=/bin/kill -INT $MAINPID
KillSignal=SIGINT
```

## Good
```ini
[Service]
KillSignal=SIGINT
TimeoutStopSec=20
```

## When to ignore it
When the program expects exactly this pair of signals, for example a first SIGINT to save its state.

## References
- systemd.service(5), ExecStop=: processes that remain are killed right afterwards
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import delete_lines

TOOL = regex(r"\bros2 (?:launch|run|bag record)\b")
RECORDER = "ros2 bag record"
"""It closes its files on SIGTERM, too, in every distribution."""
SIGNAL = regex(r"-{1,2}(?:s|signal|n)?=?\s*((?:SIG)?[A-Z][A-Z0-9]+|\d+)$")


@rule("info", fix="unsafe", symptoms=["user interrupted with ctrl-c (SIGINT) again, ignoring"])
def execstop_async_kill(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.running("kill"):
        service = robot.units.supervision(unit)
        for process in robot.units.processes(unit):
            commands = [
                step.command for step in process.steps if step.command.name != process.shell or not process.shell
            ]
            if process.key != "ExecStop" or len(commands) != 1 or commands[0].name != "kill":
                continue
            words = [str(word) for word in commands[0].words[1:]]
            if not any("MAINPID" in word for word in words):
                continue
            signal = _signal(words)
            same = signal == service.kill_signal.value
            child = _behind_shell(robot, unit) if signal == "SIGINT" and not same else None
            if child is not None:
                yield _lost(unit, process, child)
                continue
            lines = [line for line in unit.assignments("ExecStop", "Service") if line.value is process.line]
            yield finding(
                process.line,
                f"ExecStop= sends {signal} and returns at once: systemd sends "
                f"{service.kill_signal.value} right after it",
                advice="delete the line" if same else f"delete the line and set KillSignal={signal}",
                related=[note(service.kill_signal.at, "sends the same signal")]
                if same and service.kill_signal.at
                else (),
                fix=fix("leave it to KillSignal=", *map(delete_lines, lines)) if same and unit.editable else None,
            )


def _behind_shell(robot: Robot, unit: Unit) -> Step | None:
    """The command of ROS 2 that a shell, the main process, starts as its child and waits for."""
    service = robot.units.supervision(unit)
    main, mode = service.main, service.kill_mode
    stops = [process for process in robot.units.processes(unit) if process.key == "ExecStop"]
    if main is None or main.kind != "shell" or mode.value != "control-group" or len(stops) > 1:
        return None
    if service.kill_signal.value is None or "trap" in (main.script.text if main.script else service.main_line.line):
        return None
    steps = (step for step, _ in service.main_line.ros if step.shell and not step.command.background)
    return next((step for step in steps if TOOL.search(" ".join(step.command.words))), None)


def _lost(unit: Unit, process: Process, child: Step) -> Finding:
    words = child.command.words
    program = TOOL.findall(" ".join(words))[0]
    signal = unit.get("KillSignal") or "SIGTERM"
    return finding(
        process.line,
        f"ExecStop= sends SIGINT to the shell alone, which does not pass it on: {program} of {unit.name} only gets "
        f"the {signal} that systemd sends right after it",
        advice="delete the line and set KillSignal=SIGINT, which reaches all processes of the unit",
        related=[note(words[0], "the shell starts it as a child and stays the main process")],
        severity="info" if program == RECORDER and signal == "SIGTERM" else "warning",
    )


def _signal(words: list[str]) -> str:
    text = " ".join(words).partition("$")[0].strip().rstrip("\\").strip()
    match = SIGNAL.search(text) or re.search(r"-s\s+(\w+)$", text)
    name = {"2": "INT", "15": "TERM", "9": "KILL", "1": "HUP", "3": "QUIT"}.get(match[1], match[1]) if match else "TERM"
    return f"SIG{name.removeprefix('SIG')}"
