"""An assignment above the first section header: systemd ignores it.

## What it finds
A line above the first section header of a unit file: a warning for a setting, and an info for any other text, such as
the name of the unit, which systemd ignores as well.

## Why it matters on a robot
The setting has no effect, and only a message in the journal says so.

## Bad
```ini
After=network-online.target

[Unit]
Description=Drivers
```

## Good
```ini
[Unit]
Description=Drivers
After=network-online.target
```

## When to ignore it
Never: systemd ignores the line.

## References
- systemd.syntax(7)
- journal: "Assignment outside of section. Ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", symptoms=["Assignment outside of section"])
def line_outside_section(robot: Robot) -> Iterator[Finding]:
    for file, problem in robot.units.problems("line-outside-section"):
        if not file.source.template:
            is_setting = "=" in str(problem.where)
            yield finding(
                problem.where,
                "Text before the first [Section]: systemd ignores this line",
                advice="move it below the header of its section" if is_setting else "remove it, or begin it with #",
                severity=None if is_setting else "info",
            )
