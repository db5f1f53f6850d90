"""A missing disk stops the boot.

## What it finds
A mount of a block device without `nofail`, `noauto`, `_netdev` or `x-systemd.automount`. The mounts of the system
itself (/, /boot, /efi, /usr, /var, /home, /etc, /opt, /srv, /tmp, /root, /nix, /run) are not reported. /data,
/persist, /userdata and /state, where images keep what has to last, are an info.

## Why it matters on a robot
If the disk is missing or its file system is damaged, systemd waits 90 seconds for the device and then opens the
emergency shell: no network, no SSH, somebody must go to the robot.

## Bad
```
UUID=… /data ext4 defaults 0 2
```

## Good
```
UUID=… /data ext4 defaults,nofail,x-systemd.device-timeout=10s 0 2
```

## When to ignore it
When the robot must not come up without this file system.

## References
- systemd.mount(5), "nofail"
- robotics-security guide, read-only root
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

SYSTEM = ("/boot", "/efi", "/usr", "/var", "/home", "/etc", "/opt", "/srv", "/tmp", "/root", "/nix", "/run")

STATE = ("/data", "/persist", "/persistent", "/userdata", "/state")
"""Where images with a read-only root keep what has to last, on the same disk."""


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "Timed out waiting for device /dev/disk/",
        "You are in emergency mode",
        "Timed out waiting for device",
        "Dependency failed for Local File Systems",
        "Timed out waiting for device *.device - /dev/disk/by-",
        "Timed out waiting for device dev-disk-by",
    ],
)
def no_nofail(robot: Robot) -> Iterator[Finding]:
    for fstab in robot.fstabs:
        for mount in fstab.mounts:
            target = mount.target
            end = mount.end_of_options
            if target is None or end is None or not mount.is_block or not target.startswith("/"):
                continue
            system = target.rstrip("/") == "" or any(f"{target}/".startswith(f"{folder}/") for folder in SYSTEM)
            if system or mount.has("nofail", "noauto", "x-systemd.automount", "_netdev"):
                continue
            yield finding(
                target,
                f"Without {mount.device} the boot ends in the emergency shell after 90 s",
                advice="add nofail,x-systemd.device-timeout=10s",
                severity="info" if target.rstrip("/") in STATE else None,
                fix=fix("add nofail", (end, ",nofail,x-systemd.device-timeout=10s"), safe=False),
            )
