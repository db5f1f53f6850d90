"""A key in the wrong section: systemd ignores the line.

## What it finds
A key that belongs in another section of the same unit: StartLimitIntervalSec= or OnFailure= in [Service],
WantedBy= or ExecStart= in [Unit]. systemd/legacy-key reports the five old names that [Service] still accepts.

## Why it matters on a robot
The line has no effect. A start limit in [Service] never limits anything, so that a crashing driver restarts
forever. An OnFailure= in [Service] never starts the failure handler.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
Restart=always
StartLimitIntervalSec=60
```

## Good
```ini
[Unit]
StartLimitIntervalSec=60

[Service]
ExecStart=/usr/bin/robot-drivers
Restart=always
```

## When to ignore it
Never: systemd ignores the line.

## References
- systemd.unit(5): StartLimitIntervalSec= belongs in [Unit] since systemd 230
- journal: "Unknown key name 'StartLimitIntervalSec' in section 'Service', ignoring."
- https://github.com/systemd/systemd/issues/16644
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.systemd import Assignment
from bringup_lint.api.systemd import UnitFile
from bringup_lint.api.systemd import directives
from bringup_lint.api.systemd import move_lines


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Unknown key name",
        "Unknown lvalue",
        "Unknown key name 'StartLimitIntervalSec' in section 'Service'",
        "Unknown key name 'StartLimitBurst' in section 'Service'",
        "Unknown key name 'Restart' in section 'Unit'",
        "Unknown key name 'RestartSec' in section 'Unit'",
        "Unknown key name 'WantedBy' in section",
        "Unknown key name 'After' in section 'Service'",
        "Unknown key name 'ExecStart' in section 'Unit'",
        "Unknown key name 'User' in section 'Unit'",
        "Unknown key 'StartLimitIntervalSec' in section [Service], ignoring.",
        "Unknown key 'StartLimitBurst' in section [Service], ignoring.",
        "Unknown key 'Restart' in section [Unit], ignoring.",
        "Unknown key 'RestartSec' in section [Unit], ignoring.",
        "Unknown key 'WantedBy' in section [*], ignoring.",
        "Unknown key 'After' in section [Service], ignoring.",
        "Unknown key 'ExecStart' in section [Unit], ignoring.",
        "Unknown key 'User' in section [Unit], ignoring.",
    ],
)
def key_in_wrong_section(robot: Robot) -> Iterator[Finding]:
    for file in robot.units.unit_files:
        allowed = directives.sections_of_type(file.type)
        for section in file.sections:
            if section.name not in allowed:
                continue
            for assignment in section.assignments:
                key = assignment.key
                if directives.directive(section.name, key):
                    continue
                homes = [name for name in allowed if directives.directive(name, key)]
                if not homes:
                    continue
                yield finding(
                    key,
                    f"{key}= belongs in [{homes[0]}]; in [{section.name}] systemd ignores the line",
                    advice=f"move the line to [{homes[0]}]",
                    fix=_moved(file, assignment, homes[0]),
                )


def _moved(file: UnitFile, assignment: Assignment, home: str) -> Fix | None:
    """The line in the section where it belongs, unless that sets the key, too."""
    there = [each.key for section in file.sections if section.name == home for each in section.assignments]
    if file.source.template or assignment.key in there:
        return None
    return fix(f"move it to [{home}]", *move_lines(file, assignment, home))
