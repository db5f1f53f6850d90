"""`size` and daily, weekly or monthly override each other.

## What it finds
A stanza with both `size` and a time directive.

## Why it matters on a robot
Only the later of the two has an effect. If `size` is last, a log that stays small is never rotated, however
old it is. If the time is last, a flood of messages fills the disk before the next rotation.

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

## When to ignore it
When the later directive is the one that is meant. Deleting the other one says so to the next reader.

## References
- logrotate(8), "size", "maxsize"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

TIMES = ("hourly", "daily", "weekly", "monthly", "yearly")


@rule("info", symptoms=["overrides previously specified"])
def size_overrides_time(robot: Robot) -> Iterator[Finding]:
    for stanza in robot.logs.stanzas:
        size, time = stanza.own("size"), stanza.own(*TIMES)
        if size is None or time is None or stanza.skipped:
            continue
        first, last = sorted((size, time), key=lambda each: each.span.start)
        yield finding(
            last.name,
            f"{last.name} overrides {first.name}: only {last.name} has an effect",
            advice="replace size with maxsize to rotate by time, and earlier when the log is large",
            related=[note(first.span, "has no effect")],
        )
