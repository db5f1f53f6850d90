"""A unit depends on a device that systemd does not track.

## What it finds
`Requires=`, `BindsTo=`, `Requisite=`, `Wants=` or `After=` on a `.device` unit, when both are true:

- a udev rule creates its link for a subsystem that 99-systemd.rules does not tag (video4linux, usb, hidraw,
  input, i2c-dev, spidev, gpio), or it is a device of the kernel of such a subsystem (`dev-video0.device`);
- that rule lacks `TAG+="systemd"`, and for a device of the kernel nothing in the tree sets this tag.

## Why it matters on a robot
The device unit never becomes active. With a requirement, systemd waits 90 s (DefaultDeviceTimeoutSec=) and
then fails the service, although the device exists. An ordering alone has no effect.

## Bad
```ini
# SUBSYSTEM=="video4linux", ATTRS{serial}=="C1", ATTR{index}=="0", SYMLINK+="robot/camera"
[Unit]
BindsTo=dev-robot-camera.device
```

## Good
```ini
# SUBSYSTEM=="video4linux", ATTRS{serial}=="C1", ATTR{index}=="0", SYMLINK+="robot/camera", TAG+="systemd"
[Unit]
BindsTo=dev-robot-camera.device
```

## When to ignore it
When a rule outside of this tree, for example from the vendor's package, adds the tag.

## References
- systemd.device(5), "The udev Database"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

_KEYS = ("BindsTo", "Requires", "Requisite", "Wants", "After")


@rule(
    "warning",
    fix="unsafe",
    symptoms=[
        "Timed out waiting for device",
        "Job dev-",
        "Dependency failed for",
        "A dependency job for * failed",
        "failed with result 'dependency'",
        "Job dev-*.device/start timed out.",
    ],
)
def device_dep_needs_tag(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        seen = set()
        for key in _KEYS:
            for word in unit.words(key):
                if word in seen or not word.endswith(".device"):
                    continue
                seen.add(word)
                links = robot.devices.untagged(word)
                path = robot.devices.untracked(word)
                if links:
                    link = links[0]
                    yield finding(
                        word,
                        f'{word} never becomes active: systemd tracks such devices only with TAG+="systemd"',
                        advice='add TAG+="systemd" to the rule',
                        related=[note(link.name, f"creates {link.path}")],
                        fix=fix("tag the device", link.rule.before(link.token, 'TAG+="systemd"')),
                    )
                elif path:
                    yield finding(
                        word,
                        f'{word} never becomes active: systemd tracks such devices only with TAG+="systemd"',
                        advice=f'add a udev rule for {path} with TAG+="systemd", or wait for it in ExecStartPre=',
                    )
