"""size makes daily, weekly and monthly void.

## What it finds
A stanza with both `size` and a time directive.

## Why it matters on a robot
The later of the two counts alone. With `size` last, a log that stays small is never rotated, however old;
with the time last, a flood fills the disk before the next turn.

## Bad
```
/var/log/ros2/*.log {
    daily
    size 10M
}
```

## Good
```
/var/log/ros2/*.log {
    daily
    maxsize 10M
}
```

## References
- logrotate(8), "size", "maxsize"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

TIMES = ("hourly", "daily", "weekly", "monthly", "yearly")


@rule("info", symptoms=["overrides previously specified"])
def size_overrides_time(robot: Robot):
    for stanza in robot.logs.stanzas:
        size, time = stanza.own("size"), stanza.own(*TIMES)
        if size is None or time is None or stanza.skipped:
            continue
        first, last = sorted((size, time), key=lambda each: each.span.start)
        yield finding(
            last.name,
            f"{last.name} overrides {first.name}: only {last.name} counts",
            advice="write maxsize to rotate by time, or earlier when the log is large",
            related=[note(first.span, "has no effect")],
        )
