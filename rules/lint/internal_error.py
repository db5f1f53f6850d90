"""A rule or a parser failed inside.

## What it finds
An exception in bringup-lint itself. The run goes on without the rule or the file, and ends with exit code 3.

## Why it matters on a robot
What the rule would have found is missing from the report.

## Bad
```
error[lint/internal-error]: rule systemd/network-target failed: TypeError in network_target.py:41
```

## Good
```
All checks ran.
```

## References
- the issue tracker: please report the line with the file that caused it
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule


@rule("error")
def internal_error(robot: Robot) -> Iterator[Finding]:
    """Reported by the engine."""
    return ()
