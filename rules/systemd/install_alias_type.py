"""An alias that systemctl enable refuses.

## What it finds
Alias= with another type suffix than the unit, without one, or with a template and a plain unit mixed: the
alias of a template must be a template or an instance, that of a plain unit neither.

## Why it matters on a robot
systemctl enable stops with an error and enables nothing, not even the WantedBy= of the same section.

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

## References
- systemd.unit(5), "Alias="
- systemctl: "Failed to enable unit, cannot alias robot-drivers.service as drivers.target."
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Failed to enable unit, cannot alias"])
def install_alias_type(robot: Robot):
    for line in robot.units.lines:
        if line.directive.type != "aliases" or line.assignment.opaque:
            continue
        stem, _, kind = line.file.name.rpartition(".")
        for alias in line.value.words():
            other, _, suffix = alias.rpartition(".")
            if suffix != kind and "%" not in suffix:
                reason = f"an alias of a .{kind} ends in .{kind}"
            elif "@" in stem and "@" not in other and "%" not in other:
                reason = "an alias of a template is a template or an instance"
            elif "@" not in stem and "@" in other:
                reason = "a plain unit has no template or instance as alias"
            else:
                continue
            message = f"{line.file.name} cannot be aliased as {alias}: systemctl enable fails"
            yield finding(alias, message, advice=reason)
