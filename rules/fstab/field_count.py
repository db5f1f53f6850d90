"""An fstab line has too few or too many fields.

## What it finds
A line with fewer than three fields, or with a fifth or sixth field that is not a number: a comment after four
fields, or a path with a space. Lines with three fields or more than six are a warning. A comment after all six
fields is valid.

## Why it matters on a robot
`mount -a` and findmnt skip the line. systemd still reads it and mounts something else than intended: the first word
of a path with a space.

## Bad
```
/dev/sda1 /data ext4
```

## Good
```
UUID=… /data ext4 defaults 0 2
```

## When to ignore it
When a tool of your own fills in the line before the robot boots.

## References
- fstab(5)
- verified with util-linux 2.38
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["parse error at line", "ignored"])
def field_count(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            count = len(mount.fields)
            wrong = next((field for field in mount.fields[4:6] if not field.isdecimal()), None)
            if count < 3 or wrong is not None:
                what = f"has {count} fields" if wrong is None else f"has '{wrong}' instead of a number"
                yield finding(
                    wrong or mount.device,
                    f"This line {what}: mount and findmnt ignore it",
                    advice="write device, mount point, type, options, dump, pass; a space in a path is \\040",
                )
            elif count == 3 or count > 6:
                yield finding(
                    mount.device,
                    f"This line has {count} fields, but fstab lines have 4 to 6",
                    advice="write device, mount point, type, options, dump, pass",
                    severity="warning",
                )
