"""The watchdog is fed whatever happens to the robot.

## What it finds
A timer of a node that sends `WATCHDOG=1` to systemd with nothing that could keep it from doing so.

## Why it matters on a robot
`WatchdogSec=` restarts what hangs. When the notifier is a node of its own, its timer runs on while the drivers that
it should answer for are stuck: the watchdog proves that the notifier lives, and nothing more.

## Bad
```python
def beat(self):
    self.notifier.notify('WATCHDOG=1')
```

## Good
```python
def beat(self):
    if self.last_scan_age() < 1.0:
        self.notifier.notify('WATCHDOG=1')
```

## References
- sd_notify(3), WATCHDOG=1; systemd.service(5), WatchdogSec=
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule


@rule("info", confidence="medium")
def watchdog_unconditional(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.with_callbacks:
        for call, callback in nodes.fed_without_condition(robot.nodes.syntax(file), node):
            yield finding(
                file.span_of(call),
                f"{callback}() feeds the watchdog even when the robot is stuck",
                advice="send WATCHDOG=1 only while the messages of what it watches are young and its diagnostics good",
            )
