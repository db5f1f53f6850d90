"""A drop-in whose name does not end in .conf.

## What it finds
A file in the drop-in folder of a unit (`rover.service.d/`) whose name does not end in `.conf`. Exempt are
names that mark the file as disabled or as an example, such as `.disabled`, `.orig`, `.sample` or a
README.

## Why it matters on a robot
systemd reads only `*.conf` and silently ignores the rest: the override that should pin the driver to its core
does not apply.

## Bad
```
rover.service.d/override
```

## Good
```
rover.service.d/override.conf
```

## When to ignore it
When the name disables the file on purpose. Rename it to `.disabled`, which this rule exempts.

## References
- systemd.unit(5), "Description": drop-in files
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

MEANT = regex(
    r"(?:\.(?:disabled?|off|examples?|sample|dist|default|orig|old|save[d]?|md|rst|license|template|tpl)|~)$|^\.",
    re.I,
)


@rule("warning", silent="systemd does not read the file and does not report it")
def dropin_not_conf(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("systemd-dropin"):
        name = source.basename
        is_conf = re.search(r"\.conf(?![a-z])", name)
        if is_conf or MEANT.search(name) or not re.search(r"^\s*\[\w+\]\s*$", source.text, re.M):
            continue
        yield finding(
            source,
            f"systemd does not read {name}: the name of a drop-in must end in .conf",
            advice=f"rename it to {name.rpartition('.')[0] or name}.conf",
        )
