"""A value that logind cannot read: the line is ignored.

## What it finds
A value in [Login] of logind.conf or a drop-in that does not follow the grammar of its key.

## Why it matters on a robot
Shared memory is still deleted at logout, or closing the lid still suspends the robot.

## Bad
```ini
[Login]
HandleLidSwitch=ignored
```

## Good
```ini
[Login]
HandleLidSwitch=ignore
```

## References
- logind.conf(5), systemd.syntax(7), systemd.time(7)
- journal: "Failed to parse ... value, ignoring"
"""

from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["Failed to parse", "ignoring:"])
def invalid_value(robot: Robot):
    for daemon in robot.logind:
        for assignment, problem in daemons.bad_values(daemon, robot.target.newest):
            text = problem.suggestion
            yield finding(
                problem.where,
                f"{assignment.key}= takes {problem.expected}, not '{problem.where}': logind ignores the line",
                advice=f"write {text or problem.expected}",
                fix=fix(f"write {text}", (problem.where, text), safe=problem.safe) if text else None,
            )
