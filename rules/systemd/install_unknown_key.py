"""A misspelled key in [Install]: the unit is not enabled where it should be.

## What it finds
A key in [Install] that systemd does not know. Keys whose name starts with `X-` are for other programs and are
exempt.

## Why it matters on a robot
systemctl enable succeeds but creates no link: after the next boot the service does not run.

## Bad
```ini
[Install]
WantBy=multi-user.target
```

## Good
```ini
[Install]
WantedBy=multi-user.target
```

## When to ignore it
Only if the robot's systemd is newer than this tool and knows the key. Otherwise the line has no effect.

## References
- systemd.unit(5), "[Install] Section Options"
- journal: "Unknown key name 'WantBy' in section 'Install', ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest
from bringup_lint.api.systemd import directives


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "Unknown key name",
        "Unknown key '*' in section [Install], ignoring.",
        "The unit files have no installation config",
    ],
)
def install_unknown_key(robot: Robot) -> Iterator[Finding]:
    known = directives.sections()["Install"]
    for file in robot.units.unit_files:
        allowed = directives.sections_of_type(file.type)
        for assignment in file.assignments:
            key = assignment.key
            if assignment.section != "Install" or not key or key.startswith("X-") or file.is_filled_in(key):
                continue
            if any(directives.directive(name, key) for name in allowed):
                continue
            meant = nearest(key, known)
            yield finding(
                key,
                f"Unknown key '{key}' in [Install]: systemctl enable ignores it",
                advice=f"did you mean {meant[0]}?" if meant else f"use {', '.join(known)}",
                fix=fix(f"rename to {meant[0]}", (key, meant[0])) if len(meant) == 1 else None,
            )
