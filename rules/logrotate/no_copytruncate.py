"""ROS nodes keep writing to the file that logrotate renamed.

## What it finds
A stanza for ROS logs with `create` and without copytruncate, whose scripts neither restart nor stop anything.

## Why it matters on a robot
Nodes never reopen their logs. After `create` they keep writing to the renamed file, which is later compressed
or deleted. The new file stays empty, and the logs of the day that matters are gone.

## Bad
```
/var/log/ros2/*.log {
    weekly
    create 0640 robot robot
}
```

## Good
```
/var/log/ros2/*.log {
    weekly
    copytruncate
}
```

## When to ignore it
When the writer reopens its log after the rotation, or when the nodes never run during the rotation.

## References
- logrotate(8), "copytruncate"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

RESTARTS = regex(r"\b(?:try-restart|restart|reload-or-restart|stop)\b")


@rule("warning", fix="unsafe", silent="a process goes on writing to its open file without a message")
def no_copytruncate(robot: Robot) -> Iterator[Finding]:
    for stanza in robot.logs.stanzas:
        create = stanza.own("create")
        if create is None or stanza.skipped or stanza.get("copytruncate", "copy", "minage"):
            continue
        source = next(filter(None, map(robot.logs.source_of, stanza.paths)), None)
        if source is None or any(RESTARTS.search(script.body) for script in stanza.scripts):
            continue
        yield finding(
            create.name,
            "ROS nodes never reopen their logs: they keep writing to the renamed file",
            advice="replace create with copytruncate",
            related=[note(source, "ROS writes its logs here")] if isinstance(source, Located) else (),
            fix=fix("replace with copytruncate", (create.span, "copytruncate"), safe=False),
        )
