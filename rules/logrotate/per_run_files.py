"""`rotate N` never deletes the logs of finished ROS runs.

## What it finds
A stanza with a pattern for ROS logs that has `rotate` but not maxage, when no tmpfiles.d line with an age
covers the folder.

## Why it matters on a robot
Each node writes a new file in each run, with the time and the process ID in its name. `rotate 3` keeps three
rotations of each of these files: nothing is ever deleted, and the disk fills up.

## Bad
```
/var/log/ros2/*.log {
    rotate 3
    copytruncate
}
```

## Good
```
/var/log/ros2/*.log {
    rotate 3
    maxage 14
    copytruncate
}
```

## When to ignore it
When the nodes write to a fixed file name, or when a script outside of this tree deletes old runs.

## References
- logrotate(8), "maxage"
- tmpfiles.d(5), "Age"
- <https://github.com/ros2/rcl_logging/issues/100>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", silent="logrotate rotates only the names that it knows")
def per_run_files(robot: Robot) -> Iterator[Finding]:
    for stanza in robot.logs.stanzas:
        rotate = stanza.own("rotate")
        if rotate is None or stanza.skipped or stanza.get("maxage"):
            continue
        found = [(path, robot.logs.source_of(path)) for path in stanza.paths if "*" in path]
        reasons = [source for path, source in found if source is not None and not robot.logs.aged(path)]
        if reasons:
            yield finding(
                rotate.name,
                f"rotate {rotate.value} counts per file, and each ROS process of each run has its own: none is ever "
                "deleted",
                advice="add maxage 14 and a tmpfiles.d line with an age",
                related=[note(reasons[0], "ROS writes its logs here")] if isinstance(reasons[0], Located) else (),
            )
