"""A line of a NetworkManager profile is neither a section nor a key with a value.

## What it finds
A line without `=` outside of comments, or a key above the first section. GLib's key files have no other lines: `;`
starts no comment, and a value does not continue on the next line.

## Why it matters on a robot
NetworkManager ignores the whole file and logs one warning. The interface stays down, or another profile takes it.

## Bad
```ini
[connection]
id=lidar
type ethernet
```

## Good
```ini
[connection]
id=lidar
type=ethernet
```

## When to ignore it
Never: NetworkManager does not read the file.

## References
- nm-settings-keyfile(5)
- GLib, "Key-value file parser"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["is not a key-value pair, group, or comment"])
def syntax(robot: Robot) -> Iterator[Finding]:
    for profile, problem in robot.networkmanager.problems("syntax"):
        yield finding(
            problem.where,
            f"NetworkManager ignores {profile.source.basename}: this line is neither a section nor key=value",
            advice="write key=value, or start a comment with #",
        )
