"""A quote that is not closed.

## What it finds
A single or double quote without its partner, in Exec lines and in all settings whose words may be quoted.
systemd recognizes quotes anywhere in a word, so that the apostrophe of an ordinary word is also one.

## Why it matters on a robot
An open quote in an Exec line prevents the unit from loading. systemd ignores other settings with an open
quote.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot bringup.launch.py
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch robot bringup.launch.py'
```

## When to ignore it
Never: systemd ignores the line or refuses the unit.

## References
- systemd.service(5), "Command lines"; systemd.syntax(7), "Quoting"
- journal: "Unbalanced quoting, ignoring"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Unbalanced quoting", "Invalid syntax, ignoring"])
def unbalanced_quotes(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.wrong_lines:
        for problem in line.problems:
            if problem.code == "unbalanced-quotes":
                yield finding(
                    problem.where,
                    f"The quote that opens here is not closed: {line.consequence(problem)}",
                    advice="close the quote, or write two backslashes and the quote for a literal one",
                )
