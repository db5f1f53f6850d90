"""A redirect that sudo does not cover.

## What it finds
`sudo command > /etc/...` and `sudo command | tee /etc/...`: what follows is not run by `sudo`, and may not write there.
Silent in a script that asks for root itself (`EUID`, `id -u`, `whoami`, `SUDO_USER`).

## Why it matters on a robot
The shell, or tee behind a pipe, opens the file as the user of the script: "Permission denied". The udev rule, the
kernel parameter or the unit is never written, and the set-up goes on without it.

## Bad
```sh
sudo echo 'SUBSYSTEM=="tty", GROUP="dialout"' > /etc/udev/rules.d/99-arm.rules
```

## Good
```sh
echo 'SUBSYSTEM=="tty", GROUP="dialout"' | sudo tee /etc/udev/rules.d/99-arm.rules > /dev/null
```

## When to ignore it
When root runs the script, for example in the build of an image.

## References
- sudo(8), "Examples"
- ShellCheck SC2024
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["/etc/*: Permission denied"])
def sudo_redirect(robot: Robot) -> Iterator[Finding]:
    refused = list(robot.scripts.refused())
    of_root = set(_run_by_root(robot)) if refused else ()
    for source, (first, *others) in refused:
        if source in of_root:
            continue
        more = f" (and {len(others)} more)" if others else ""
        yield finding(
            first.where,
            f"{first.path}{more} is opened without sudo: permission denied, and nothing is written",
            advice=f"write ... | sudo tee {first.path}",
            related=[note(other.where, "not opened either") for other in others[:20]],
        )


def _run_by_root(robot: Robot) -> Iterator[Source | None]:
    """The scripts that units start without another user."""
    for unit in robot.units.services:
        if unit.get("User") in (None, "root", "0"):
            for process in robot.units.processes(unit):
                yield from (step.script for step in process.steps)
