"""After= names a unit that nothing starts.

## What it finds
- `After=` of a service in the same tree that nothing starts: it has no `[Install]` section, no unit wants or
  requires it, and no timer, socket, path or device activates it.
- `After=` of a device that no unit wants, requires or mounts: systemd waits for a device only where a unit asks for it.
  It is a warning where nothing restarts the service. Silent where a udev rule starts the service, for disks, which
  mounts ask for, and for interfaces of which the tree names an instance (`wpa_supplicant@wlan0`).

## Why it matters on a robot
`After=` orders two units if both start, but it starts neither. The unit that should come first never runs,
and this one starts at once: a driver before its board is there, which works at one boot and fails at the next.

## Bad
```ini
[Unit]
After=calibration.service
```

## Good
```ini
[Unit]
Wants=calibration.service
After=calibration.service
```

## When to ignore it
When something outside of this tree starts the other unit: a script with `systemctl start`, a fleet agent, or
another package.

## References
- systemd.unit(5), "After="
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Assignment
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Units

DISK = regex(r"dev-(?:disk|mapper|sd[a-z]|nvme|mmcblk|md)")
INTERFACE = "sys-subsystem-net-devices-"


@rule("info", fix="unsafe", silent="an order between units that do not both start has no effect and is not reported")
def after_without_requires(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        for line in unit.assignments("After"):
            if not line.opaque:
                yield from _services(robot.units, unit, line)
                yield from _devices(robot, unit, line)


def _services(units: Units, unit: Unit, line: Assignment) -> Iterator[Finding]:
    for word in line.value.words():
        other = units.find(word, unit)
        if other is None or other is unit or other.type != "service" or other.unsure_of() or units.is_started(other):
            continue
        yield finding(
            word,
            f"Nothing starts {word}, so After= has no effect",
            advice=f"add Wants={word}, or give {word} an [Install] section",
            related=[note(other.where, "it has no [Install] section and nothing wants it")],
            fix=fix(f"add Wants={word}", (line.end, f"\nWants={word}"), safe=False),
        )


def _devices(robot: Robot, unit: Unit, line: Assignment) -> Iterator[Finding]:
    words = [word for word in line.value.words() if word.endswith(".device") and "%" not in word]
    lost = [word for word in words if not robot.units.awaits_device(unit, word) and not _is_untracked(robot, word)]
    lost = [word for word in lost if not DISK.match(word) and not _has_instance(robot, word)]
    if lost and not unit.unsure_of():
        yield finding(
            lost[0],
            f"After= alone waits for no device: {unit.name} starts whether {' or '.join(lost)} is there or not",
            advice="add Wants= or BindsTo= for the device that this robot has",
            severity="warning" if robot.units.restart(unit).restart == "no" else "info",
            fix=fix(f"add Wants={lost[0]}", (line.end, f"\nWants={lost[0]}"), safe=False),
        )


def _is_untracked(robot: Robot, word: str) -> bool:
    """Whether systemd hears nothing of the device, so that nothing can wait for it."""
    return bool(robot.devices.untagged(word) or robot.devices.untracked(word))


def _has_instance(robot: Robot, word: str) -> bool:
    """Whether the tree names an instance for the interface: the templates of the distribution ask for its device."""
    name = word.removeprefix(INTERFACE).removesuffix(".device")
    return name != word.removesuffix(".device") and robot.files.mentions(re.compile(rf"@{re.escape(name)}\b"))
