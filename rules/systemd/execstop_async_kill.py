"""ExecStop= only repeats what KillSignal= does.

## What it finds
ExecStop= that runs `kill` on $MAINPID and nothing else.

## Why it matters on a robot
`kill` returns at once, and systemd then sends KillSignal= anyway. ros2 launch ignores a second SIGINT. A
SIGTERM after the SIGINT makes it exit before its nodes have stopped.

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
from bringup_lint.api.systemd import delete_lines

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


def _signal(words: list[str]) -> str:
    text = " ".join(words).partition("$")[0].strip().rstrip("\\").strip()
    match = SIGNAL.search(text) or re.search(r"-s\s+(\w+)$", text)
    name = {"2": "INT", "15": "TERM", "9": "KILL", "1": "HUP", "3": "QUIT"}.get(match[1], match[1]) if match else "TERM"
    return f"SIG{name.removeprefix('SIG')}"
