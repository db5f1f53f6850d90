"""A launch file hides its errors.

## What it finds
`except:` without an exception type, when the block does not raise again.

## Why it matters on a robot
After a missing file or package, the launch description silently starts less than it should.

## Bad
```python
try:
    share = get_package_share_directory('my_lidar')
except:
    share = ''
```

## Good
```python
try:
    share = get_package_share_directory('my_lidar')
except PackageNotFoundError:
    share = ''
```

## When to ignore it
When the block around it is optional on every robot, such as a developer's visualisation, and a log message says
that it was skipped.

## References
- PEP 8, "Programming Recommendations"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info", silent="the launch file hides the error itself")
def bare_except(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for span in file.bare_excepts:
            yield finding(
                span.source.span(span.start, min(span.end, span.start + len("except:"))),
                "Every error in this block is hidden: launch silently starts less than it should",
                advice="name the expected exception",
            )
