"""Rules are copied, and udev is not told.

## What it finds
A script that copies files to a `rules.d` folder of udev and neither runs `udevadm control --reload` or
`udevadm trigger`, nor restarts udev or the machine, nor says that somebody has to.

## Why it matters on a robot
Devices that are plugged in keep the names and modes that they have. The links that drivers open are not there until
each device is plugged in anew or the robot is started again, and the first start after the set-up fails.

## Bad
```sh
sudo cp 99-rover.rules /etc/udev/rules.d/
```

## Good
```sh
sudo cp 99-rover.rules /etc/udev/rules.d/
sudo udevadm control --reload && sudo udevadm trigger
```

## When to ignore it
When the script is a step of the making of an image, or whoever calls it tells udev.

## References
- udevadm(8), "udevadm control", "udevadm trigger"
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.shell import runs_in_image

TOLD = regex(
    r"udevadm|udev\s+(?:restart|reload)|(?:restart|reload)\s+\S*udev|\breboot\b|\bchroot\b|shutdown\s+-r",
    re.I,
    hints="udev reboot chroot shutdown",
)
FOLDER = "/udev/rules.d"


@rule("warning", symptoms=["No such file or directory: '/dev/", "could not open port /dev/*No such file or directory"])
def udev_not_reloaded(robot: Robot) -> Iterator[Finding]:
    copied: dict[Source, list[Located]] = {}
    for source, run in robot.scripts.run("cp", "install", "ln", "mv"):
        target = run.text(run.words[-1]) if len(run.words) > 2 else ""
        if target.startswith(("/etc", "/lib", "/usr/lib")) and FOLDER in target:
            copied.setdefault(source, []).append(run.words[-1])
    telling = [each for each in robot.sources if each.kind == "dockerfile" or TOLD.search(each.said)] if copied else []
    for source, (first, *others) in copied.items():
        if TOLD.search(source.said) or _is_called(telling, source) or runs_in_image(source):
            continue
        yield finding(
            first,
            "udev is not told of the new rules: devices that are plugged in keep their names and modes",
            advice="run udevadm control --reload and udevadm trigger afterwards",
            related=[note(other, "rules are copied here too") for other in others],
        )


def _is_called(telling: list[Source], source: Source) -> bool:
    """Whether another file that tells udev, or builds an image, names the script."""
    return any(each is not source and source.basename in each.text for each in telling)
