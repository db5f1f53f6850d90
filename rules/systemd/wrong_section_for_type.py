"""A section of another unit type: systemd ignores it.

## What it finds
A section that belongs to another unit type, such as [Service] in a .target or [Timer] in a .service.

## Why it matters on a robot
systemd ignores the section. The process never starts, or the timer never runs, but the unit still loads
without an error.

## Bad
```ini
# robot-bringup.target
[Service]
ExecStart=/usr/bin/robot-bringup
```

## Good
```ini
# robot-bringup.service
[Service]
ExecStart=/usr/bin/robot-bringup
```

## When to ignore it
Never: systemd ignores the section.

## References
- systemd.unit(5): each type of unit has a section of its own
- journal: "Unknown section 'Service'. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import directives


@rule(
    "error",
    symptoms=[
        "Unknown section 'Timer'. Ignoring",
        "Unknown section 'Socket'. Ignoring",
        "Unknown section",
    ],
)
def wrong_section_for_type(robot: Robot) -> Iterator[Finding]:
    homes = {section: kind for kind, section in directives.SECTION_OF_TYPE.items()}
    for file in robot.units.unit_files:
        for section in file.sections:
            if section.name in homes and section.name not in directives.sections_of_type(file.type):
                yield finding(
                    section.name,
                    f"[{section.name}] has no meaning in a .{file.type} unit: systemd ignores everything in it",
                    advice=f"move the settings to a .{homes[section.name]} unit",
                )
