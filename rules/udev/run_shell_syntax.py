"""A command contains shell syntax, but no shell runs it.

## What it finds
`&&`, `|`, `>`, `;` or `&` in `RUN`, `PROGRAM` or `IMPORT{program}` outside `/bin/sh -c '...'`.

## Why it matters on a robot
udev starts the program directly and passes these characters as arguments: a command after them never runs,
and a redirection writes no file.

## Bad
```udev
KERNEL=="ttyACM*", RUN+="/bin/echo 1 > /sys/class/leds/link/brightness"
```

## Good
```udev
KERNEL=="ttyACM*", RUN+="/bin/sh -c 'echo 1 > /sys/class/leds/link/brightness'"
```

## When to ignore it
If the program itself expects the character as an argument, as `find ... -exec ... ;` does.

## References
- udev(7), RUN
- https://github.com/IntelRealSense/librealsense/issues/11842
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["' failed with exit code"])
def run_shell_syntax(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for command in line.commands:
            if command.shell_operators:
                sign = command.shell_operators[0]
                wrapped = f"/bin/sh -c '{command.text}'"
                quoted = any(mark in command.text for mark in "'\"")
                yield finding(
                    sign,
                    f"No shell runs this command: {command.name.rstrip(';')} gets '{sign}' as an argument",
                    advice="write /bin/sh -c '...'",
                    fix=None if quoted else fix("run it in a shell", (command.text, wrapped), safe=False),
                )
