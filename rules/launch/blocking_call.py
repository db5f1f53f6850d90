"""A launch file waits for something by itself, and everything else waits with it.

## What it finds
In a Python launch file, outside `try`, in code that runs while the launch is evaluated or in an `OpaqueFunction`:

- `time.sleep()` of two seconds and more, all rounds of its loop together;
- `subprocess.run(..., check=True)`, `check_call()` and `check_output()` without `timeout=` of programs that need a
  network, a device or much time, such as docker, curl, openocd, nmcli and ros2.

Calls with `timeout=`, handlers of events and files for tests and simulation are not reported.

## Why it matters on a robot
launch evaluates its files in the loop that also starts, watches and stops the processes. While the call lasts, no node
starts, a node that died is not noticed, and Ctrl-C or the stop of the service has no effect until the timeout kills
the launch. An exception of the program ends the whole launch: without Internet, or without the board, no node starts.

## Bad
```python
def flash(context):
    subprocess.run(['openocd', '-f', 'base.cfg'], check=True)
```

## Good
```python
flash = ExecuteProcess(cmd=['openocd', '-f', 'base.cfg'])
start = RegisterEventHandler(OnProcessExit(target_action=flash, on_exit=[driver]))
```

## When to ignore it
When nothing may start before the call has ended, and it ends soon.

## References
- launch, `LaunchService.run_async` and `OpaqueFunction.execute`
- https://docs.ros.org/en/rolling/Tutorials/Intermediate/Launch/Using-Event-Handlers.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Wait
from bringup_lint.api.systemd import duration

SECONDS = 2.0
"""A pause from which a launch that is stopped meanwhile is noticeably late."""


@rule("warning", symptoms=["Command '*' returned non-zero exit status"])
def blocking_call(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        waits = [each for each in file.waits if each.seconds is None or each.seconds >= SECONDS]
        if waits and not robot.launch.simulated(file):
            yield finding(
                waits[0].span,
                _message(waits[0]),
                advice="start it with ExecuteProcess, and what needs it in an OnProcessExit handler",
                related=[note(each.span, _short(each)) for each in waits[1:]],
            )


def _message(wait: Wait) -> str:
    meanwhile = "no node is started, watched or stopped meanwhile"
    if wait.is_before and wait.seconds is None:
        return (
            f"Reading the launch file runs {wait.name}, also for ros2 launch --show-args: nothing starts before it has "
            "ended, and nothing at all when it fails"
        )
    if wait.seconds is None:
        return f"The whole launch waits for {wait.name}, and ends with an exception when it fails: {meanwhile}"
    return f"The whole launch waits {_time(wait)}: {meanwhile}"


def _short(wait: Wait) -> str:
    return f"waits for {wait.name}" if wait.seconds is None else f"waits {_time(wait)}"


def _time(wait: Wait) -> str:
    endless = wait.seconds is None or wait.seconds == float("inf")
    return "without limit" if endless else f"up to {duration(wait.seconds or 0)}"
