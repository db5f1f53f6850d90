"""A mount option is misspelt.

## What it finds
An option that the file system does not have but that differs by one or two letters from an existing one. Checked
for ext4, vfat, exFAT, tmpfs, overlay, and for the options of all file systems. Other unknown options are not
reported.

## Why it matters on a robot
The kernel rejects the mount: the boot ends in the emergency shell, or the robot comes up without its data.

## Bad
```
UUID=… /data ext4 defaults,nofial 0 2
```

## Good
```
UUID=… /data ext4 defaults,nofail 0 2
```

## When to ignore it
When a patched kernel or a newer file system has an option with this name.

## References
- mount(8)
- systemd.mount(5)
- ext4(5), tmpfs(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", symptoms=["Unknown parameter", "bad option"])
def bad_option(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            known = robot.mount_options(str(mount.type or ""))
            if not known:
                continue
            for option in mount.options:
                name = option.partition("=")[0]
                near = (
                    nearest(name, known)
                    if name not in known and not name.startswith(("x-", "x.", "X-", "comment"))
                    else []
                )
                if near:
                    yield finding(
                        option,
                        f"Unknown mount option '{name}': the mount fails at boot",
                        advice=f"did you mean {' or '.join(near)}?",
                    )
