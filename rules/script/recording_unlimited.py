"""A recording that starts by itself fills the disk.

## What it finds
`ros2 bag record` of all topics (`-a`, `--all`) in a unit, a container with a restart policy or a cron job, or in a
script that one of these starts, when nothing in the tree deletes recordings.

## Why it matters on a robot
Images and point clouds are gigabytes an hour. `--max-bag-size` and `--max-bag-duration` only split the recording. When
the disk is full, logs, updates and everything else that writes fail, and the robot may not start any more.

## Bad
```sh
ros2 bag record -a
```

## Good
```sh
find /var/lib/rover/bags -mtime +2 -delete
exec ros2 bag record --max-bag-duration 600 -o "/var/lib/rover/bags/$(date +%F-%H%M)" /odom /scan /diagnostics
```

## When to ignore it
When something outside of the tree deletes recordings, or the file system has a quota.

## References
- https://github.com/ros2/rosbag2, "Splitting files during recording"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.docker import Runner
from bringup_lint.api.docker import recordings

DELETES = regex(
    r"\b(?:rm|find|tmpreaper|rmtree|unlink)\b[^\n]{0,200}\b\w*bags?(?:\b|_)|bags?\b[^\n]{0,100}-(?:delete|mtime)\b"
)
ALL = ("-a", "--all", "--all-topics")


@rule("warning", symptoms=["No space left on device"])
def recording_unlimited(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("bag"):
        return
    seen = set()
    for runner, words in recordings(robot.runners.all):
        if runner.restarts is False and not _starts_at_boot(robot, runner):
            continue
        if not set(ALL) & set(words) or words[2].span in seen:
            continue
        seen.add(words[2].span)
        if not robot.mentions(DELETES):
            yield finding(
                words[2],
                f"{runner.name} records all topics at every start, and nothing deletes the recordings: "
                "the disk fills up",
                advice="name the topics, and delete old recordings before the start",
                related=[note(runner.where, f"{runner.name} starts it")],
                confidence="medium",
            )


def _starts_at_boot(robot: Robot, runner: Runner) -> bool:
    """Whether a unit records once after each start of the computer."""
    return runner.unit is not None and any(robot.units.wanted_by(runner.unit))
