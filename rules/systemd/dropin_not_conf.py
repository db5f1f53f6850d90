"""A drop-in that does not end in .conf.

## What it finds
A file in the drop-in folder of a unit (`rover.service.d/`) under a name that does not end in `.conf`. Names
that say that the file is switched off or an example (`.disabled`, `.bak`, `.sample`, a README) are left
out.

## Why it matters on a robot
systemd reads `*.conf` and nothing else, without a word about the rest: the override that was to keep the
driver on its core is not there.

## Bad
```
rover.service.d/override
```

## Good
```
rover.service.d/override.conf
```

## References
- systemd.unit(5), "Description": drop-in files
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

MEANT = re.compile(
    r"(?:\.(?:disabled?|off|examples?|sample|dist|default|orig|old|save[d]?|md|rst|license|template|tpl)|~)$|^\.",
    re.I,
)


@rule("warning")
def dropin_not_conf(robot: Robot):
    for source in robot.of_kind("systemd-dropin"):
        name = source.basename
        if ".conf" in name or MEANT.search(name) or not re.search(r"^\s*\[\w+\]\s*$", source.text, re.M):
            continue
        yield finding(
            source,
            f"{name} is not read: systemd takes only drop-ins whose names end in .conf",
            advice=f"rename it to {name.rpartition('.')[0] or name}.conf",
        )
