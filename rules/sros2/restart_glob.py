"""A rotation script restarts units by a pattern, which matches loaded units only.

## What it finds
`systemctl restart`, `try-restart` or `reload-or-restart` with a wildcard in a shell script that runs `ros2
security`.

## Why it matters on a robot
systemctl compares the pattern with the units in memory. A stopped unit is usually not in memory: systemctl
skips it without a message, and it stays down although the rotation should bring it back with new keys.

## Bad
```sh
systemctl restart 'robot-*.service'
```

## Good
```sh
systemctl restart robot-base.service robot-navigation.service
```

## When to ignore it
With `try-restart`, or if stopped units should stay stopped: they read the new keys when they start.

## References
- systemctl(1), "Parameter Syntax"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="systemctl restarts the units that match and says nothing of the others")
def restart_glob(robot: Robot) -> Iterator[Finding]:
    for _, commands in robot.sros2.scripts("ros2 security"):
        for command in commands:
            words = [word for word in command.words if not word.startswith("-")]
            at = next((at for at, word in enumerate(words) if word.rpartition("/")[2] == "systemctl"), None)
            if at is None or words[at + 1 : at + 2] not in (["restart"], ["try-restart"], ["reload-or-restart"]):
                continue
            for word in words[at + 2 :]:
                if "*" in word and "$" not in word:
                    yield finding(
                        word,
                        f"{word} matches loaded units only: a unit that is not loaded stays stopped",
                        advice="name the units, or restart a target that they are part of",
                    )
