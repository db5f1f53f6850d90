"""A script replaces a whole file of the distribution.

## What it finds
`>` or `tee` without `-a` on a file that the distribution fills: `/etc/sysctl.conf`, `/etc/sudoers`,
`/etc/ssh/sshd_config`, `/etc/NetworkManager/NetworkManager.conf`, `/etc/passwd`, `/etc/group`, `/etc/modules`,
`/etc/default/grub`, `/etc/bash.bashrc`. In Debian and Ubuntu, `/etc/sysctl.conf` and `/etc/modules` hold comments
only: an info, unless another script of the tree writes to the same file. Also `cp` or `install` of a file of the tree
over `/etc/sudoers` in a tree where no file names `visudo`.

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

import posixpath
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
SUDOERS = "/etc/sudoers"
CHECK = "visudo"
READ = 200_000
"""How much of a file is searched for it."""
KEEPS = frozenset(("-n", "--no-clobber"))
"""Options of cp that leave a file as it is."""
PAIR = 2
"""Of what is copied, and where to."""
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
    copied = list(_copied(robot))
    if copied and not any(CHECK in robot.tree.start(path, READ) for path in robot.tree.paths):
        yield from copied


def _copied(robot: Robot) -> Iterator[Finding]:
    """The copies over the file of sudo, which nobody can mend as soon as it has a mistake."""
    for source, run in robot.scripts.run("cp", "install"):
        paths = [word for word in run.words[1:] if not word.startswith("-")]
        if len(paths) < PAIR or KEEPS.intersection(run.words):
            continue
        given, to = paths[-PAIR:]
        name, target = posixpath.basename(run.text(given)), run.text(to).rstrip("/")
        is_whole = target == SUDOERS or posixpath.join(target, name) == SUDOERS
        if is_whole and robot.tree.beside(source, run.text(given)) is not None:
            yield finding(
                to,
                f"This replaces the whole of {SUDOERS}: after a mistake in the new one nobody can use sudo any more",
                advice=f"write a file in {FOLDERS[SUDOERS]}",
                confidence=None if run.certain else "medium",
            )
