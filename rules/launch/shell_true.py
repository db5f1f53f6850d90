"""An argument's value is given to a shell.

## What it finds
`shell=True` on a process whose command holds a launch configuration or an environment variable.

## Why it matters on a robot
Whatever is passed as the argument is run by the shell: a name with a blank breaks the command, one with a semicolon
runs another.

## Bad
```python
ExecuteProcess(cmd=['ros2 bag record -o ', LaunchConfiguration('bag')], shell=True)
```

## Good
```python
ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', LaunchConfiguration('bag')])
```

## References
- CWE-78
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", tags=["CWE-78"])
def shell_true(robot: Robot) -> Iterator[Finding]:
    for _, action in robot.launch.actions(launch.Process):
        shell = action.options.get("shell")
        if shell is None or launch.truth(shell) is not True:
            continue
        words = (*action.cmd, *getattr(action, "arguments", ()))
        open_ = [
            each for word in words for each in launch.walk(word) if isinstance(each, (launch.Argument, launch.Env))
        ]
        if open_:
            yield finding(
                shell.span,
                f"The value of '{open_[0].name}' is given to a shell: it can run any command",
                advice="give the command as a list, without shell",
                related=[note(open_[0].span, "this value")],
            )
