"""A launch file uses the home folder of the current user.

## What it finds
`os.path.expanduser()` in launch files that are not for simulation.

## Why it matters on a robot
Under systemd the home folder is that of `User=`, or there is none. The path then names another file than the one
that was tested in the shell.

## Bad
```python
config = os.path.expanduser('~/robot.yaml')
```

## Good
```python
config = LaunchConfiguration('config')   # passed by the unit, below /etc or the package's share folder
```

## When to ignore it
When the launch file is started only by a person on a workstation, never by a service.

## References
- systemd.exec(5), "User=" and `$HOME`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="the path of the current user's home folder is valid")
def expanduser(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if robot.launch.simulated(file):
            continue
        for call in file.calls:
            if call.name == "os.path.expanduser":
                yield finding(
                    call.span,
                    "Under systemd the home folder is that of User=: the path differs from the one in your shell",
                    advice="use an absolute path or an argument",
                )
