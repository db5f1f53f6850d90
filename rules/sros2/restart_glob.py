"""A rotation restarts units by a pattern, which matches only those that are loaded.

## What it finds
`systemctl restart` or `try-restart` with a wildcard in a shell script that works with keys of SROS2.

## Why it matters on a robot
systemctl matches units in memory: one that is stopped or has failed is left out without a word, and comes back with the
old credentials.

## Bad
```sh
systemctl restart 'robot-*.service'
```

## Good
```sh
systemctl restart robot-base.service robot-navigation.service
```

## References
- systemctl(1), "Parameter Syntax"
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def restart_glob(robot: Robot):
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
                        f"{word} matches loaded units only: one that is stopped or failed keeps its old credentials",
                        advice="name the units, or restart a target that they are part of",
                    )
