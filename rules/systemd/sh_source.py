"""Bash syntax in /bin/sh.

## What it finds
`sh` reads `source`, or reads a `setup.bash` or `.bashrc` with a dot, in the `-c` text of a unit or in a
script of the tree that a unit starts.

## Why it matters on a robot
On Ubuntu and Debian, `/bin/sh` is dash. It has no `source` ("source: not found"), and a `setup.bash` fails in
it at the first bash keyword. The service exits at once or continues without the ROS environment.

## Bad
```ini
[Service]
ExecStart=/bin/sh -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## When to ignore it
When `/bin/sh` on the robot is bash, as on Fedora or in some Yocto images.

## References
- dash(1)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import SH_IS_BASH
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Step

OF_BASH = regex(r"\.(?:bash|bashrc|bash_profile)$")
SHEBANG = regex(r"#!\s*(/(?:usr/)?bin/(?:da)?sh)\b")


@rule("error", fix="unsafe", symptoms=["source: not found", 'Syntax error: "(" unexpected'])
def sh_source(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            for step in process.steps:
                words = step.command.words
                if step.shell not in ("sh", "dash") or len(words) < 2:
                    continue
                if words[0] == "source":
                    message = "/bin/sh is dash on Ubuntu and Debian and has no 'source'"
                elif words[0] == "." and OF_BASH.search(words[1]):
                    message = f"/bin/sh is dash on Ubuntu and Debian and cannot read {words[1]}"
                else:
                    continue
                if step.shell == "sh" and robot.mentions(SH_IS_BASH):
                    continue
                shell = _shell(process, step)
                yield finding(
                    words[0],
                    f"{message}: the command fails, and later commands have no ROS environment",
                    advice="run it with /bin/bash",
                    related=[note(process.program, f"{unit.name} starts it here")] if step.script else (),
                    fix=fix("use /bin/bash", (shell, "/bin/bash")) if shell is not None else None,
                )


def _shell(process: Process, step: Step) -> Located | Span | None:
    """The word that chooses sh, when it is this one and no other."""
    if step.script is None:
        return process.program if process.shell in ("sh", "dash") and step.depth == 1 else None
    shebang = SHEBANG.match(step.script.text)
    named = any(other.depth == step.depth - 1 and other.command.name in ("sh", "dash") for other in process.steps)
    return step.script.span(*shebang.span(1)) if shebang and not named else None
