"""A socket unit that listens on nothing: systemd refuses it.

## What it finds
A socket unit without any Listen...= setting, after all drop-ins.

## Why it matters on a robot
systemd refuses the unit and never activates its service.

## Bad
```ini
[Socket]
Accept=yes
```

## Good
```ini
[Socket]
ListenStream=8080
Accept=yes
```

## When to ignore it
When a drop-in outside of this tree adds the address.

## References
- systemd.socket(5)
- journal: "Unit has no Listen setting (ListenStream=, ListenDatagram=, ListenFIFO=, ...). Refusing."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.systemd import directives


@rule("error", symptoms=["Unit has no Listen setting"])
def socket_no_listen(robot: Robot) -> Iterator[Finding]:
    keys = [key for key in directives.sections()["Socket"] if key.startswith("Listen")]
    for unit in robot.units.judged:
        if unit.type != "socket" or unit.fragment is None or unit.uncertain:
            continue
        if not any(unit.has(key) for key in keys):
            yield finding(
                unit.where,
                f"{unit.name} listens on nothing: systemd refuses it",
                advice="add a Listen...= line",
            )
