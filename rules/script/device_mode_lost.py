"""A script changes the mode of a device node.

## What it finds
`chmod` on a path below `/dev` in a script that starts no program afterwards, and that no unit, container or cron job
runs. One finding for each script.

## Why it matters on a robot
udev makes the node again at the next boot, and whenever the device is plugged in, with the mode of its rules. The
driver that worked yesterday then fails with `Permission denied` until somebody runs the script.

## Bad
```sh
sudo chmod 777 /dev/ttyUSB0
```

## Good
```sh
# in /etc/udev/rules.d/70-lidar.rules:
# SUBSYSTEM=="tty", ATTRS{idVendor}=="10c4", GROUP="dialout", MODE="0660"
sudo udevadm control --reload
```

## When to ignore it
When something outside of the tree runs the script after every boot, and the device is never unplugged.

## References
- udev(7), "MODE", "GROUP"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.shell import Run

QUIET = ("echo", "printf", "exit", "true", "set", "")
PSEUDO = ("/dev/shm", "/dev/null", "/dev/std", "/dev/pts", "/dev/mqueue", "/dev/dri")


@rule("warning", symptoms=["Permission denied: '/dev/"])
def device_mode_lost(robot: Robot) -> Iterator[Finding]:
    changed: dict[Source, list[Located]] = {}
    for source, run in robot.scripts.run("chmod"):
        for word in run.words[2:]:
            path = run.text(word)
            if path.startswith("/dev/") and not path.startswith(PSEUDO):
                changed.setdefault(source, []).append(word)
    for first, *others in changed.values():
        if robot.scripts.starts_by_itself(first.span.source) or _goes_on(robot, first.span.source):
            continue
        yield finding(
            first,
            f"udev makes {first} again at the next boot, with its own mode: the device is closed until somebody "
            "runs this script",
            advice="set GROUP= and MODE= in a udev rule",
            related=[note(word, f"the mode of {word} is lost too") for word in others],
        )


def _goes_on(robot: Robot, source: Source) -> bool:
    """Whether the script starts something after it has changed the modes, so that it is how the program is started."""
    names = [did.name for did in robot.scripts.done(source) if isinstance(did, Run) and did.name not in QUIET]
    return bool(names) and names[-1] != "chmod"
