"""`**` in a logrotate path means no more than `*`.

## What it finds
`**` in a path of a stanza.

## Why it matters on a robot
logrotate uses glob(3): `~/.ros/log/**/*.log` matches only files exactly one folder down. The launch logs of
each run are there. The logs of the nodes are in ~/.ros/log itself and are never rotated.

## Bad
```
/home/robot/.ros/log/**/*.log {
    weekly
}
```

## Good
```
/home/robot/.ros/log/*.log /home/robot/.ros/log/*/*.log {
    weekly
}
```

## When to ignore it
When all logs are exactly one folder down. Write `*` then, which means the same and misleads nobody.

## References
- logrotate(8), glob(7)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", symptoms=["error: stat of */** failed: No such file or directory"])
def globstar(robot: Robot) -> Iterator[Finding]:
    for stanza in robot.logs.stanzas:
        for path in stanza.paths:
            if "/**/" not in path:
                continue
            before, _, after = path.partition("/**/")
            both = f"{before}/{after} {before}/*/{after}"
            plain = path == path.span.text and "**" not in after
            yield finding(
                path,
                f"'**' matches one level only: {before}/{after} and anything deeper than one folder are not rotated",
                advice=f"list the levels: {both}",
                fix=fix("list both levels", (path, both)) if plain else None,
            )
