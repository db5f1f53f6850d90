"""OnFailure= names an instance of a template that does not exist.

## What it finds
OnFailure= with a template instance such as `robot-alarm@%n.service`, when the tree has no
`robot-alarm@.service`. It is a warning instead of an error when the tree ships no other unit to the same
place.

## Why it matters on a robot
When the service fails, systemd logs that the unit was not found and does nothing: no alarm, no safe stop.

## Bad
```ini
[Unit]
OnFailure=robot-alarm@%n.service
```

## Good
```ini
# robot-alarm@.service, in the same package
[Service]
Type=oneshot
ExecStart=/opt/robot/bin/alarm %i
```

## When to ignore it
When another package ships the template.

## References
- systemd.unit(5), OnFailure= and "Specifiers"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Failed to enqueue OnFailure= job, ignoring: Unit not found"])
def onfailure_template_missing(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    for unit in units.judged:
        for word in (*unit.words("OnFailure", "Unit"), *unit.words("OnFailure", "Service")):
            stem, _, suffix = word.rpartition(".")
            prefix, at, _ = stem.partition("@")
            template = f"{prefix}@.{suffix}"
            if not at or not prefix or "%" in prefix or unit.is_opaque(word) or unit.manager == "user":
                continue
            if units.candidates(word, unit.manager) or units.is_provided(template) is not False:
                continue
            shipped = robot.tree.complete or any(other.place == unit.place for other in units.all if other is not unit)
            yield finding(
                word,
                f"The failure handler {template} does not exist: when {unit.name} fails, nothing happens",
                advice=f"ship {template}",
                severity="error" if shipped else "warning",
            )
