"""A data mount allows setuid files and device nodes.

## What it finds
A tmpfs, or a block device below /data, /mnt, /media or /srv, without `nosuid` and `nodev`.

## Why it matters on a robot
Anybody who can put a file there, with a USB stick or an upload, can have a program that runs as root.

## Bad
```
UUID=… /data ext4 defaults,nofail 0 2
```

## Good
```
UUID=… /data ext4 defaults,nofail,nosuid,nodev 0 2
```

## When to ignore it
When the mount holds programs that need setuid, such as an overlay of a root file system.

## References
- robotics-security guide, read-only root
- mount(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("info", fix="unsafe", silent="the mount works", tags=["CWE-250"])
def data_nosuid(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            target = mount.target
            end = mount.end_of_options
            if target is None or end is None or target in ("/run", "/dev/shm"):
                continue
            data = mount.is_block and target.startswith(("/data", "/mnt", "/media", "/srv"))
            missing = [name for name in ("nosuid", "nodev") if not mount.has(name, "user", "users")]
            if missing and (data or mount.is_tmpfs):
                yield finding(
                    target,
                    f"{target} allows setuid files and device nodes",
                    advice=f"add {','.join(missing)}",
                    fix=fix(f"add {','.join(missing)}", (end, "," + ",".join(missing))),
                )
