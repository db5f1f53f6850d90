"""Nothing reads the result of a check.

## What it finds
A process that tests something, without an exit action or an `OnProcessExit` handler. A direct `test` or `[` command
is an error. A script that is called check, verify or preflight is a warning.

## Why it matters on a robot
In launch, a failing process does not stop anything. The device is missing, nothing reports it, and the robot
starts. A timer may even print a message such as "hardware checks passed".

## Bad
```python
ExecuteProcess(cmd=['test', '-e', '/dev/lidar']),
TimerAction(period=2.0, actions=[LogInfo(msg='Hardware checks passed')]),
```

## Good
```python
check = ExecuteProcess(cmd=['test', '-e', '/dev/lidar'])
RegisterEventHandler(OnProcessExit(target_action=check, on_exit=lambda event, context:
    [] if event.returncode == 0 else [EmitEvent(event=Shutdown(reason='no lidar'))]))
```

## When to ignore it
When the script only reports, or when it stops the robot by other means, such as a service call or `systemctl stop`.
The linter sees only the exit handlers of the launch file.

## References
- launch, `ExecuteProcess` and `OnProcessExit`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import rule


@rule("error", confidence="medium", silent="the result of the check is dropped")
def check_ignored(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        expansion = robot.launch.expansion(file)
        for node in expansion.nodes:
            check = launch.check_of(node) if node.file is file else None
            if check is None or launch.watched(node, expansion):
                continue
            direct = check.startswith(("test ", "[ "))
            yield finding(
                node.span,
                f"If the check '{check}' fails, the launch continues: nothing waits for its result",
                advice="register an OnProcessExit handler that shuts the launch down when the check fails",
                severity=None if direct else "warning",
            )
