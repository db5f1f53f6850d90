"""Drop-ins that sshd does not read: the main file has no Include for them.

## What it finds
A sshd_config.d with files, next to a sshd_config that does not include it.

## Why it matters on a robot
Someone replaced the distribution's sshd_config. The drop-ins have no effect, including those that a package
or cloud-init writes later.

## Bad
```
# sshd_config
Port 2222
```

## Good
```
# sshd_config
Include /etc/ssh/sshd_config.d/*.conf
Port 2222
```

## When to ignore it
When sshd_config is meant to be the only source and the drop-ins are leftovers of the image.

## References
- sshd_config(5), "Include"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", silent="sshd does not read the files and does not report them")
def include_missing(robot: Robot) -> Iterator[Finding]:
    for sshd in robot.sshd:
        if sshd.main is None or not sshd.complete or not sshd.main.source.judged or sshd.main.source.template:
            continue
        includes = [word for option in sshd.main.options if option.name == "Include" for word in option.arguments]
        if sshd.dropins and not any("sshd_config.d" in word for word in includes):
            yield finding(
                sshd.main.source,
                "sshd does not read sshd_config.d: there is no Include for it",
                advice="begin the file with Include /etc/ssh/sshd_config.d/*.conf",
                related=[note(sshd.dropins[0].source, "sshd does not read this file")],
            )
