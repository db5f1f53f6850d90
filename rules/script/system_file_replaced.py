"""A script replaces a whole file of the distribution.

## What it finds
`>` or `tee` without `-a` on a file that the distribution fills: `/etc/sysctl.conf`, `/etc/sudoers`,
`/etc/ssh/sshd_config`, `/etc/NetworkManager/NetworkManager.conf`, `/etc/passwd`, `/etc/group`, `/etc/modules`,
`/etc/default/grub`, `/etc/bash.bashrc`. In Debian and Ubuntu, `/etc/sysctl.conf` and `/etc/modules` hold comments
only: an info, unless another script of the tree writes to the same file.

## Why it matters on a robot
Everything that the distribution, another script or the administrator had set in the file is gone, and an update of the
package stops and asks about the difference. A second run of another set-up script adds its lines again, this one
takes them away.

## Bad
```sh
echo 'kernel.panic = 10' | sudo tee /etc/sysctl.conf
```

## Good
```sh
echo 'kernel.panic = 10' | sudo tee /etc/sysctl.d/60-rover.conf
```

## When to ignore it
When the script writes the whole content of the file on purpose.

## References
- sysctl.d(5): files in /etc/sysctl.d are for local settings
- sudoers(5), "Including other files"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import rule

FOLDERS = {
    "/etc/sysctl.conf": "/etc/sysctl.d",
    "/etc/sudoers": "/etc/sudoers.d, with visudo -c",
    "/etc/ssh/sshd_config": "/etc/ssh/sshd_config.d",
    "/etc/NetworkManager/NetworkManager.conf": "/etc/NetworkManager/conf.d",
    "/etc/modules": "/etc/modules-load.d",
    "/etc/default/grub": "/etc/default/grub.d",
    "/etc/bash.bashrc": "/etc/profile.d",
    "/etc/passwd": "",
    "/etc/group": "",
}
"""Files that the distribution fills, and where settings of one's own belong."""
EMPTY = ("/etc/sysctl.conf", "/etc/modules")
"""Those of them that have nothing but comments (packages procps and kmod)."""
FEW = 3
"""Lines; who writes more means the whole file."""


@rule("warning", symptoms=["==> Modified (by you or by a script) since installation."])
def system_file_replaced(robot: Robot) -> Iterator[Finding]:
    writers: dict[str, set[Source]] = {}
    for source, written in robot.scripts.written(*FOLDERS):
        writers.setdefault(written.path, set()).add(source)
    for _, written in robot.scripts.written(*FOLDERS):
        if written.appends or written.path not in FOLDERS or written.text is None:
            continue
        if str(written.text).count("\n") <= FEW:
            folder = FOLDERS[written.path]
            yield finding(
                written.where,
                f"This replaces the whole of {written.path}: everything else in it is lost",
                advice=f"write a file in {folder}" if folder else "use adduser, usermod and groupadd",
                confidence=None if written.certain else "medium",
                severity="info" if written.path in EMPTY and len(writers[written.path]) == 1 else None,
            )
