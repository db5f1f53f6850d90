"""A check runs and nobody looks at its result.

## What it finds
Processes that test something (`test -e /dev/lidar`, a script called check, verify or preflight) without an exit
action or an `OnProcessExit` handler.

## Why it matters on a robot
A process that fails stops nothing in launch. The device is missing, the check says so to nobody, and the robot
starts; a message such as "hardware checks passed" after a timer is even printed.

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

## References
- launch, `ExecuteProcess` and `OnProcessExit`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import rule


@rule("error", confidence="medium")
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
                f"The check '{check}' may fail and the launch goes on: nothing waits for its result",
                advice="register an OnProcessExit handler that shuts down when it fails",
                severity=None if direct else "warning",
            )
