"""A variable is set twice, and only the last value applies.

## What it finds
The same name twice in a file that a unit reads with EnvironmentFile=. A warning if the values differ, info if they
are equal. A variable that Environment= and a file set differently, or two files of one unit, is info, because it
may be an intended override.

## Why it matters on a robot
Somebody changes the first line, and the robot does not react. Of Environment= and EnvironmentFile=, the file
applies, regardless of the order of the lines.

## Bad
```sh
ROS_DOMAIN_ID=1
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
ROS_DOMAIN_ID=42
```

## Good
```sh
RMW_IMPLEMENTATION=rmw_cyclonedds_cpp
ROS_DOMAIN_ID=42
```

## When to ignore it
When a second file is meant to override the first, such as an optional file with settings for one robot.

## References
- systemd.exec(5), "EnvironmentFile=": settings from these files override Environment=
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.environment import UsedEnvFile
from bringup_lint.api.systemd import Unit

_SECRET = regex(r"PASS|SECRET|TOKEN|KEY|PSK", re.I)


@rule("warning", silent="shells and systemd take the last value without a message")
def duplicate(robot: Robot) -> Iterator[Finding]:
    for file in robot.env_files:
        yield from _within(file)
    for unit in robot.units.judged:
        if unit.has("Environment") or unit.has("EnvironmentFile"):
            yield from _across(robot, unit)


def _within(file: UsedEnvFile) -> Iterator[Finding]:
    last = {str(entry.name): entry for entry in file.model.entries}
    for entry in file.entries:
        final = last[entry.name]
        if entry is final:
            continue
        same = entry.value == final.value
        ending = "to the same value" if same else f"and the last value{_shown(final.name, final.value)} applies"
        yield finding(
            entry.name,
            f"{entry.name} is set twice in this file, {ending}",
            advice="delete one of the two",
            related=[
                note(final.name, "set again here"),
                note(file.readers[0].value, "the service reads the file here"),
            ],
            severity="info" if same else None,
        )


def _across(robot: Robot, unit: Unit) -> Iterator[Finding]:
    """Environment= and files, or two files of one unit; only the setting that loses against another origin."""
    environment = robot.units.environment(unit)
    for name, chain in environment.chains.items():
        settings = [variable for variable in chain if variable.text is not None]
        if len(settings) < 2:
            continue
        lost, final = settings[-2], settings[-1]
        if final.value.path == lost.value.path or final.text == lost.text:
            continue
        yield finding(
            lost.value,
            f"{name} is set twice for {unit.name}: {final.origin}{_shown(name, final.text)} overrides {lost.origin}",
            advice="delete one of the two",
            related=[note(final.value, "this value applies")],
            severity="info",
        )


def _shown(name: Located | str, value: str | None) -> str:
    return "" if value is None or _SECRET.search(name) or len(value) > 40 else f" ({value})"
