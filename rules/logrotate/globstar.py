"""** in a logrotate path is no more than *.

## What it finds
`**` in a path of a stanza.

## Why it matters on a robot
logrotate's patterns are those of glob(3): `~/.ros/log/**/*.log` matches files one folder down only. The
launch logs of each run are there; the logs of the nodes lie in ~/.ros/log itself and are never rotated.

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

## References
- logrotate(8), glob(7)
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe")
def globstar(robot: Robot):
    for stanza in robot.logs.stanzas:
        for path in stanza.paths:
            if "/**/" not in path:
                continue
            before, _, after = path.partition("/**/")
            both = f"{before}/{after} {before}/*/{after}"
            plain = path == path.span.text and "**" not in after
            yield finding(
                path,
                f"'**' is one level only: {before}/{after} is not rotated, nor anything deeper than one folder",
                advice=f"list the levels: {both}",
                fix=fix("list both levels", (path, both)) if plain else None,
            )
