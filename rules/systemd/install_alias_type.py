"""An alias that systemctl enable rejects.

## What it finds
An Alias= that does not match the unit:

- its type suffix is missing or differs from that of the unit;
- a template has an alias that is neither a template nor an instance;
- a plain unit has a template or an instance as its alias.

## Why it matters on a robot
systemctl enable exits with an error and enables nothing, not even the WantedBy= of the same section.

## Bad
```ini
# robot-drivers.service
[Install]
Alias=drivers.target
```

## Good
```ini
# robot-drivers.service
[Install]
Alias=drivers.service
```

## When to ignore it
Never: systemctl enable fails.

## References
- systemd.unit(5), "Alias="
- systemctl: "Failed to enable unit, cannot alias robot-drivers.service as drivers.target."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Failed to enable unit, cannot alias"])
def install_alias_type(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.lines:
        if line.directive.type != "aliases" or line.assignment.opaque:
            continue
        stem, _, kind = line.file.name.rpartition(".")
        for alias in line.value.words():
            other, _, suffix = alias.rpartition(".")
            if suffix != kind and "%" not in suffix:
                reason = f"the alias of a .{kind} unit must end in .{kind}"
            elif "@" in stem and "@" not in other and "%" not in other:
                reason = "the alias of a template must be a template or an instance"
            elif "@" not in stem and "@" in other:
                reason = "the alias of a plain unit must be neither a template nor an instance"
            else:
                continue
            message = f"{line.file.name} cannot be aliased as {alias}: systemctl enable fails"
            yield finding(alias, message, advice=reason)
