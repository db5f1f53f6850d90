"""A quote that is opened and not closed.

## What it finds
A single or double quote without its partner, in Exec lines and in all settings whose words may be quoted.
systemd groups with quotes anywhere in a word, so the apostrophe of an ordinary word counts too.

## Why it matters on a robot
An Exec line with an open quote stops the unit from loading; other settings are dropped.

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
    for line in robot.units.lines:
        for problem in line.problems:
            if problem.code == "unbalanced-quotes":
                yield finding(
                    problem.where,
                    f"The quote that opens here is not closed: {line.consequence(problem)}",
                    advice="close the quote, or write two backslashes and the quote for a literal one",
                )
