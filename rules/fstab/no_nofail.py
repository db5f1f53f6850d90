"""A missing disk stops the boot.

## What it finds
A mount of a block device without `nofail`, `noauto`, `_netdev` or `x-systemd.automount`. The mounts of the system
itself (/, /boot, /efi, /usr, /var, /home, /etc, /opt, /srv, /tmp, /root, /nix, /run) are not reported. /data,
/persist, /userdata and /state, where images keep what has to last, are an info. A task of Ansible that writes the line
by the module `mount` counts, too, and so does a script that appends the line to /etc/fstab.

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

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import Module
from bringup_lint.api.shell import Written
from bringup_lint.api.shell import tasks
from bringup_lint.api.yaml import Mapping

SYSTEM = ("/boot", "/efi", "/usr", "/var", "/home", "/etc", "/opt", "/srv", "/tmp", "/root", "/nix", "/run")

MODULE = regex(r"^[ \t-]*(?:ansible\.posix\.)?mount:[ \t]*$", re.M, "mount:")
DISK = regex(r"/dev/|(?:PART)?(?:UUID|LABEL)=")
ON_DISK = ("ext2", "ext3", "ext4", "xfs", "btrfs", "f2fs", "vfat", "exfat", "ntfs", "ntfs3", "auto")
OPTIONAL = regex(r"nofail|noauto|_netdev|x-systemd\.automount|\{\{")

FIELD = r"(?:\{\{[^{}\n]*\}\}|[^\s{}#])+"
APPENDED = regex(
    rf"^[ \t]*(?P<device>(?:/dev/|(?:PART)?(?:UUID|LABEL)=){FIELD})[ \t]+(?P<target>{FIELD})[ \t]+(?P<type>{FIELD})"
    rf"[ \t]+(?P<options>{FIELD})",
    re.M,
)
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
            if _is_system(target) or mount.has("nofail", "noauto", "x-systemd.automount", "_netdev"):
                continue
            yield finding(
                target,
                f"Without {mount.device} the boot ends in the emergency shell after 90 s",
                advice="add nofail,x-systemd.device-timeout=10s",
                severity="info" if target.rstrip("/") in STATE else None,
                fix=fix("add nofail", (end, ",nofail,x-systemd.device-timeout=10s"), safe=False),
            )
    for _, did in robot.scripts.written("fstab"):
        if did.path == "/etc/fstab" and did.appends:
            yield from _of_line(did)
    for source in robot.of_kind("ansible"):
        if source.judged and MODULE.search(source.text) and robot.purpose(source).value == "robot":
            for task in tasks(source):
                yield from (_of_module(each) for each in task.modules if _stops_boot(each))


def _of_line(did: Written) -> Iterator[Finding]:
    for line in APPENDED.finditer(str(did.text or "")):
        target = line["target"]
        is_disk = line["type"] in ON_DISK or "{{" in line["type"]
        if is_disk and not OPTIONAL.search(line["options"]) and not _is_system(target):
            device = "this disk" if "{{" in line["device"] else line["device"]
            yield finding(
                did.where,
                f"Without {device} the boot ends in the emergency shell after 90 s",
                advice="write nofail,x-systemd.device-timeout=10s into the options of the line",
                severity="info" if target.rstrip("/") in STATE else None,
            )


def _is_system(target: str) -> bool:
    """Whether it is a mount of the system itself, without which nothing works anyway."""
    return target.rstrip("/") == "" or any(f"{target}/".startswith(f"{folder}/") for folder in SYSTEM)


def _stops_boot(module: Module) -> bool:
    """Whether the task writes a line for a disk that has to be there."""
    settings = module.settings
    if module.name != "mount" or not isinstance(settings, Mapping):
        return False
    said = {key: _text(settings, key) for key in ("src", "path", "fstype", "opts", "state", "boot")}
    is_disk = DISK.match(said["src"]) is not None and said["fstype"] in ON_DISK
    if not is_disk or said["state"] not in ("mounted", "present") or said["boot"].lower() in ("false", "no"):
        return False
    return not OPTIONAL.search(said["opts"]) and not _is_system(said["path"])


def _text(settings: Mapping, key: str) -> str:
    found = settings.scalar(key)
    return str(found.value) if found is not None else ""


def _of_module(module: Module) -> Finding:
    assert isinstance(module.settings, Mapping)
    opts = module.settings.scalar("opts")
    source = _text(module.settings, "src")
    return finding(
        opts.value if opts is not None else module.key,
        f"Without {'this disk' if '{{' in source else source} the boot ends in the emergency shell after 90 s",
        advice="write opts: defaults,nofail,x-systemd.device-timeout=10s",
    )
