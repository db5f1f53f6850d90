"""A node asks for the name of who has logged in, where nobody has.

## What it finds
`os.getlogin()` in Python nodes and the modules beside them, outside of a `try` that takes an OSError.

## Why it matters on a robot
`getlogin()` asks which user the terminal belongs to. A service of systemd, a cron job and a container have no
terminal: the call raises OSError, and the node ends, although it ran in the shell of whoever wrote it.

## Bad
```python
log_folder = f'/home/{os.getlogin()}/logs'
```

## Good
```python
log_folder = os.path.expanduser('~/logs')
user = getpass.getuser()
```

## When to ignore it
When the program is only ever started by hand, in a terminal.

## References
- https://docs.python.org/3/library/os.html#os.getlogin
- getlogin(3): ENXIO, ENOTTY
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule

_CAUGHT = frozenset({"OSError", "IOError", "EnvironmentError", "FileNotFoundError", "Exception", "BaseException"})


@rule(
    "warning",
    symptoms=[
        "OSError: [Errno 6] No such device or address",
        "OSError: [Errno 25] Inappropriate ioctl for device",
    ],
)
def login_name(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.robot_code:
        if "getlogin" not in file.source.text:
            continue
        syntax = robot.nodes.syntax(file)
        for call in syntax.named.get("os.getlogin", ()):
            if not syntax.catches(call, _CAUGHT) and not syntax.is_dead(call):
                yield finding(
                    file.span_of(call),
                    "os.getlogin() raises OSError without a terminal, as under systemd, cron or in a container, and "
                    f"{nodes.end_of(syntax, call)}",
                    advice="use getpass.getuser(), or os.path.expanduser('~') for the home folder",
                    severity=robot.nodes.lowered_if_vendored(file.source, "warning"),
                )
