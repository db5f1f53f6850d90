"""CYCLONEDDS_URI does not point to the file.

## What it finds
A value that Cyclone DDS reads as another path than intended: `file:/x`, `file://name` (relative to the working
folder), `FILE://`, a `~`, or a variable where nothing expands it. Inline XML and several entries between commas are
valid.

## Why it matters on a robot
Cyclone DDS cannot open its configuration: no domain is created, and no node starts.

## Bad
```sh
CYCLONEDDS_URI=file://cyclonedds.xml
```

## Good
```sh
CYCLONEDDS_URI=file:///etc/robot/cyclonedds.xml
```

## When to ignore it
When every process has the same working folder and the relative path is intended.

## References
- Cyclone DDS manual, "Configuration"; each form tried with 0.10.5 and 11.0.1
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["can't open configuration file", "failed to create domain"])
def cyclonedds_uri_malformed(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.settings:
        if setting.name != "CYCLONEDDS_URI" or "<" in setting.value or (setting.text is None and setting.expands):
            continue
        for part in re.finditer(r"[^,]+", setting.value):
            where = setting.value.part(*part.span()).strip_located()
            told = _fault(where, setting.expands)
            if told is not None:
                yield finding(
                    where,
                    f"{told}: no node starts",
                    advice="write file:///absolute/path, with three slashes",
                    fix=_fix(where),
                )


def _fault(uri: str, expands: bool) -> str | None:
    if uri.startswith("FILE:"):
        return f"Cyclone DDS accepts only 'file:' in lower case, and looks for a file called '{uri}'"
    if re.match(r"file:/(?!/)", uri):
        return f"'{uri}' lacks two slashes, so Cyclone DDS reads it as a file name"
    path = uri.removeprefix("file://")
    if path.startswith("~") and not expands:
        return f"'~' is not expanded in '{uri}'"
    if uri.startswith("file://") and path and not path.startswith(("/", "$", "~")):
        return f"'{uri}' is relative to the working folder of each process"
    return None


def _fix(where: Located) -> Fix | None:
    if re.match(r"file:/(?!/)", where):
        return fix("write three slashes", (where, where.replace("file:/", "file:///", 1)))
    return None
