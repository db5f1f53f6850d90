"""A unit of the robot has failed, or cannot start.

## What it finds
Units of the tree that systemd reports as failed, as masked although the files do not mask them, or as not loaded
because a line of them is wrong. `bringup-lint live` asks systemd on the machine on which it runs; a unit that this
machine does not have is not reported.

## Why it matters on a robot
The other units come up, and the robot moves without the part that failed. A masked unit starts never, and nobody
reports it: `systemctl enable` on an image that was built from another robot leaves the mask in place.

## Bad
```yaml
units:
- {unit: otter.service, load: loaded, active: failed, result: exit-code}
```

## Good
```yaml
units:
- {unit: otter.service, load: loaded, active: active, result: success}
```

## When to ignore it
When the unit is stopped or masked on this robot on purpose.

## References
- systemctl(1), "show"
- systemd.unit(5), "Masked"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.live import RunningUnit

BROKEN = ("bad-setting", "error")


@rule("error", symptoms=["Unit entered failed state."])
def unit_failed(robot: Robot) -> Iterator[Finding]:
    for unit, running in robot.observed.loaded_units:
        told = state(running)
        if told:
            message, advice = told
            said = note(running.name, "what systemd says")
            yield finding(unit.where, f"{running.name} {message}", advice=advice, related=[said])


def state(running: RunningUnit) -> tuple[str, str] | None:
    """What is wrong with a running unit, and what to do; None when nothing is."""
    if running.load == "masked":
        return "is masked on the robot: it never starts", f"unmask it: systemctl unmask {running.name}"
    if running.load in BROKEN:
        return "is not loaded: a line of it is wrong", f"look at it: systemctl status {running.name}"
    if running.active == "failed":
        why = f": {running.result}" if running.result else ""
        return f"has failed{why}", f"look at its log: journalctl -b -u {running.name}"
    return None
