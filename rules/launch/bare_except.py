"""A launch file swallows its errors.

## What it finds
`except:` without an exception type that does not raise again.

## Why it matters on a robot
A missing file or package ends in a launch description that silently starts less than it should.

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

## References
- PEP 8, "Programming Recommendations"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("info")
def bare_except(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for span in file.bare_excepts:
            yield finding(
                span.source.span(span.start, min(span.end, span.start + len("except:"))),
                "Every error of this block is swallowed: less starts than should, without a word",
                advice="name the exception that is expected",
            )
