"""A rule or a parser has failed.

## What it finds
An exception in bringup-lint itself. The run continues without the rule or the file, and exits with code 3.

## Why it matters on a robot
The report lacks the findings of the failed rule.

## Bad
```
error[lint/internal-error]: rule systemd/network-target failed: TypeError in network_target.py:41
```

## Good
```
All checks ran.
```

## When to ignore it
Never: report the defect. Until it is fixed, `--ignore` with the failing rule skips it.

## References
- the issue tracker: please report the line with the file that caused it
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule


@rule("error", silent="only bringup-lint reports it")
def internal_error(robot: Robot) -> Iterator[Finding]:
    """Reported by the engine."""
    return iter(())
