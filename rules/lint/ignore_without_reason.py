"""A suppression comment gives no reason.

## What it finds
`bringup-lint: ignore[...]` without a reason after it: `: reason`, or ` -- reason` where the format allows it (an XML
comment must not contain `--`).

## Why it matters on a robot
The next person cannot distinguish a decision from a shortcut.

## Bad
```ini
# bringup-lint: ignore[systemd/restart-unlimited]
Restart=always
```

## Good
```ini
# bringup-lint: ignore[systemd/restart-unlimited]: the safety node must retry forever
Restart=always
```

## When to ignore it
Never: write the reason, which takes no longer than a second comment.

## References
- the README, "Suppressing findings"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule


@rule("warning", silent="it is about a comment that only bringup-lint reads")
def ignore_without_reason(robot: Robot) -> Iterator[Finding]:
    """Reported by the engine when all other rules have run."""
    return iter(())
