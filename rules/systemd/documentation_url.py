"""A documentation link that systemd does not accept.

## What it finds
A word in Documentation= that does not start with http://, https://, file:, man: or info:.

## Why it matters on a robot
systemctl status does not show the link. The engineer who debugs the robot at night does not find the page.

## Bad
```ini
[Unit]
Documentation=www.example.org/robot
```

## Good
```ini
[Unit]
Documentation=https://www.example.org/robot
```

## When to ignore it
Never: systemd ignores the word.

## References
- systemd.unit(5), "Documentation="; uri(7)
- journal: "Invalid URL, ignoring"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", symptoms=["Invalid URL, ignoring"])
def documentation_url(robot: Robot) -> Iterator[Finding]:
    for line in robot.units.wrong_lines:
        for problem in line.problems:
            if line.directive.type == "documentation" and problem.code == "invalid":
                yield finding(
                    problem.where,
                    f"'{problem.where}' is not a URI that Documentation= accepts: systemd ignores it",
                    advice="write a complete URI that starts with https://, file:, man: or info:",
                )
