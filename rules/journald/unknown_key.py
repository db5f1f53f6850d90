"""A key that journald does not know: it ignores the line.

## What it finds
A key in [Journal] of journald.conf or a drop-in that journald ignores:

- error: no release of systemd knows the key;
- warning: the key is newer than the robot's release.

## Why it matters on a robot
The limit that should keep the disk from filling up, or the setting that should preserve the logs of a crash,
has no effect.

## Bad
```ini
[Journal]
SystemMaxSize=1G
```

## Good
```ini
[Journal]
SystemMaxUse=1G
```

## When to ignore it
The warning, when the same file is deployed to robots with older and newer releases, and the older ones can do
without the setting. Never ignore the error: the key has no effect anywhere.

## References
- journald.conf(5)
- journal: "Unknown key name '...' in section 'Journal', ignoring."
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import daemons
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["Unknown key name", "Unknown lvalue", "Unknown key '*' in section [Journal]"])
def unknown_key(robot: Robot) -> Iterator[Finding]:
    yield from daemons.unknown_keys(robot.journald, robot.target)
