"""A key that systemd does not know: it ignores the line.

## What it finds
A key that no section of this unit type has: a misspelled name, wrong capitals, or a setting of another unit
type. Keys whose name starts with `X-` are for other programs and are exempt. The misspelt trigger of a
timer that has no other is systemd/timer-no-trigger.

## Why it matters on a robot
systemd ignores the line with one message in the journal and starts the unit anyway. The watchdog that should
restart a hung driver, or the memory limit that should protect the rest of the robot, does not exist.

## Bad
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
WatchDogSec=30
```

## Good
```ini
[Service]
ExecStart=/usr/bin/robot-drivers
WatchdogSec=30
```

## When to ignore it
Only if the robot's systemd is newer than this tool and knows the key.

## References
- systemd.directives(7)
- journal: "Unknown key name 'WatchDogSec' in section 'Service', ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest
from bringup_lint.api.systemd import directives
from bringup_lint.api.systemd import misspelt_trigger

_ONE_VALUE = ("enum", "bool", "timespan", "user", "signal", "mode")
"""Kinds of values of which the last one counts."""


@rule(
    "error", fix="unsafe", symptoms=["Unknown key name", "Unknown lvalue", "Unknown key '*' in section [*], ignoring."]
)
def unknown_key(robot: Robot) -> Iterator[Finding]:
    reported = {misspelt.key.span for misspelt in map(misspelt_trigger, robot.units.judged) if misspelt}
    for file in robot.units.unit_files:
        allowed = directives.sections_of_type(file.type)
        for section in file.sections:
            if section.name not in allowed or section.name == "Install":
                continue
            given = {str(each.key) for each in section.assignments}
            for assignment in section.assignments:
                key = assignment.key
                if directives.directive(section.name, key):
                    continue
                if not key or key.startswith("X-") or file.is_filled_in(key) or key.span in reported:
                    continue
                if not any(directives.directive(name, key) for name in allowed):
                    yield _unknown(key, section.name, given)


def _unknown(key: Located, section: str, keys: set[str]) -> Finding:
    message = f"Unknown key '{key}' in [{section}]: systemd ignores the line"
    if directives.directive(section, f"Condition{key}"):
        return finding(key, message, advice=f"did you mean Condition{key}?")
    homes = directives.sections_with(key)
    meant = nearest(key, directives.sections()[section])
    if homes:
        return finding(key, message, advice=f"{key}= belongs in [{'] or ['.join(homes)}] of another unit type")
    if not meant:
        return finding(key, message, advice="remove the line, or see systemd.directives(7) for the right name")
    is_clear = len(meant) == 1 and not (meant[0] in keys and is_for_one_value(section, meant[0]))
    change = fix(f"rename to {meant[0]}", (key, meant[0])) if is_clear else None
    return finding(key, message, advice=f"did you mean {meant[0]}?", fix=change)


def is_for_one_value(section: str, key: str) -> bool:
    """Whether a second line of the key would take the place of the first, or make systemd refuse the unit."""
    found = directives.directive(section, key)
    return key == "ExecStart" or (found is not None and found.type.partition(":")[0] in _ONE_VALUE)
