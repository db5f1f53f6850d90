"""A shell interprets the value of an argument.

## What it finds
`shell=True` on a process whose command contains a launch configuration or an environment variable.

## Why it matters on a robot
The shell runs whatever is passed as the argument. A name with a space breaks the command, and one with a semicolon
runs another command.

## Bad
```python
ExecuteProcess(cmd=['ros2 bag record -o ', LaunchConfiguration('bag')], shell=True)
```

## Good
```python
ExecuteProcess(cmd=['ros2', 'bag', 'record', '-o', LaunchConfiguration('bag')])
```

## When to ignore it
When the value comes only from your own launch files and can never contain spaces or shell characters, such as a
number. A command list without a shell avoids the question.

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


@rule("warning", silent="the shell runs what it is given", tags=["CWE-78"])
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
                f"A shell interprets the value of '{open_[0].name}': it can run any command",
                advice="pass the command as a list, without a shell",
                related=[note(open_[0].span, "this value")],
            )
