"""An fstab line has too few or too many fields.

## What it finds
A line with fewer than three fields, or with something that is no number in the fifth or sixth: a comment
behind four fields, or a path with a blank. As a warning: three fields, or more than six. A comment behind
all six is fine.

## Why it matters on a robot
`mount -a` and findmnt pass over the line. systemd reads on and mounts something else than was meant: the
first word of a path with a blank.

## Bad
```
/dev/sda1 /data ext4
```

## Good
```
UUID=… /data ext4 defaults 0 2
```

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
                what = f"has {count} fields" if wrong is None else f"has '{wrong}' where a number belongs"
                yield finding(
                    wrong or mount.device,
                    f"This line {what}: mount and findmnt ignore it",
                    advice="write device, mount point, type, options, dump, pass; a blank in a path is \040",
                )
            elif count == 3 or count > 6:
                yield finding(
                    mount.device,
                    f"This line has {count} fields, fstab has 4 to 6",
                    advice="write device, mount point, type, options, dump, pass",
                    severity="warning",
                )
