"""A script that uses sudo forgets it for one command.

## What it finds
In a script that starts what changes the system with `sudo`: `apt install`, `dpkg -i`, and `cp`, `mv`, `ln`, `install`,
`mkdir`, `rm`, `touch`, `chmod`, `chown`, `tee` and a redirect below `/etc`, `/usr`, `/lib`, `/boot` and `/opt/ros`
without it. Not reported: scripts that ask who runs them (`EUID`, `id -u`, `SUDO_USER`), that an image, a service or
`sudo` of another script starts, and commands whose failure is expected (`if`, `||`, `2>/dev/null`).

## Why it matters on a robot
The command runs as the user of the script: "Permission denied". With `set -e` the installation stops in the middle.
Without it the unit, the rule or the list of packages is missing, and what follows fails or goes on without it.

## Bad
```sh
sudo cp rover.rules /etc/udev/rules.d/
cp rover.service /etc/systemd/system/
```

## Good
```sh
sudo cp rover.rules /etc/udev/rules.d/
sudo cp rover.service /etc/systemd/system/
```

## When to ignore it
When people start the script as root.

## References
- sudo(8)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import without_sudo

MOST = 20


@rule("warning", symptoms=["Permission denied", "are you root?"])
def sudo_missing(robot: Robot) -> Iterator[Finding]:
    for script in without_sudo(robot.scripts):
        first, *others = script.without
        more = f" (and {len(others)} more)" if others else ""
        what = f"may not write {first.path}" if first.path else "may not install packages"
        yield finding(
            first.where,
            f"No sudo here{more}: the user of the script {what}, and the command fails",
            advice="write sudo before it, as elsewhere in the script",
            related=[
                note(script.with_sudo, "with sudo"),
                *(note(other.where, "without it too") for other in others[:MOST]),
            ],
        )
