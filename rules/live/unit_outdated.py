"""systemd runs another version of a unit than the files hold.

## What it finds
Units of which a file has changed since systemd has read it (`NeedDaemonReload=yes`), and units that systemd has loaded
from another path than that of the file in the tree. `bringup-lint live` asks systemd on the machine on which it runs.

## Why it matters on a robot
The file says one thing and the robot does another: a new restart limit, user or environment file has no effect before
`systemctl daemon-reload` and a restart, and an edited copy that another path shadows never has.

## Bad
```yaml
units:
- {unit: otter.service, load: loaded, active: active, reload: yes}
```

## Good
```yaml
units:
- {unit: otter.service, load: loaded, active: active}
```

## When to ignore it
When the new files shall count from the next boot on.

## References
- systemctl(1), "daemon-reload"
- systemd.unit(5), "Unit File Load Path"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=["The unit file, source configuration file or drop-ins of * changed on disk."],
)
def unit_outdated(robot: Robot) -> Iterator[Finding]:
    for unit, running in robot.observed.loaded_units:
        own = unit.fragment.source.robot_path if unit.fragment else None
        if running.reload == "yes":
            yield finding(
                unit.where,
                f"systemd runs {running.name} as it was before its files changed",
                advice="systemctl daemon-reload, and restart the unit",
                related=[note(running.name, "NeedDaemonReload=yes")],
            )
        elif own and running.fragment and merged(running.fragment) != merged(own):
            yield finding(
                unit.where,
                f"systemd runs {running.name} from {running.fragment}, not from this file",
                advice="remove the file that shadows the other one",
                related=[note(running.fragment, "the file that is loaded")],
            )


def merged(path: str) -> str:
    """A path on a system whose /lib is a link to /usr/lib."""
    return path.removeprefix("/usr") if path.startswith("/usr/lib/") else path
