r"""The name of a device unit means another path.

## What it finds
A `.device` name in a dependency whose path no udev rule creates, while a rule creates the path that differs
only in `-`. In unit names, `-` means `/`, and a dash is written `\x2d`.

## Why it matters on a robot
systemd waits 90 s for a device that cannot appear, then fails the service.

## Bad
```ini
# SYMLINK+="robot/front-lidar"
[Unit]
BindsTo=dev-robot-front-lidar.device
```

## Good
```ini
# SYMLINK+="robot/front-lidar"
[Unit]
BindsTo=dev-robot-front\x2dlidar.device
```

## When to ignore it
When a rule outside of this tree creates the path that the unit name means.

## References
- systemd-escape(1)
- systemd.unit(5), "String Escaping for Inclusion in Unit Names"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

_KEYS = ("BindsTo", "Requires", "Requisite", "Wants", "After", "PartOf", "WantedBy")


@rule("error", fix="unsafe", symptoms=["Timed out waiting for device"])
def device_unit_escape(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        for key in _KEYS:
            for word in unit.words(key, "Install") if key == "WantedBy" else unit.words(key):
                meant = robot.devices.meant_by(word)
                if meant is not None:
                    yield finding(
                        word,
                        f"{word} does not mean {meant.link.path} but another path: the device never appears",
                        advice=f"write {meant.unit}",
                        related=[note(meant.link.name, f"creates {meant.link.path}")],
                        fix=fix("escape the dash", (word, meant.unit)),
                    )
