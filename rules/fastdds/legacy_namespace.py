"""A Fast DDS file uses the older namespace.

## What it finds
The namespace `http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles`. The library ignores namespaces, so the
file works.

## Why it matters on a robot
Editors and checkers that use the schema reject the file, and real mistakes are lost among their messages.

## Bad
```xml
<profiles xmlns="http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles">
```

## Good
```xml
<profiles xmlns="http://www.eprosima.com">
```

## When to ignore it
If you do not use an editor or checker with the schema.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("info", fix="safe", silent="Fast DDS ignores namespaces")
def legacy_namespace(robot: Robot) -> Iterator[Finding]:
    legacy = "http://www.eprosima.com/XMLSchemas/fastRTPS_Profiles"
    for profiles in robot.dds.profile_files:
        for element in profiles.document.elements:
            value = element.get("xmlns")
            if value == legacy:
                yield finding(
                    value,
                    "The older namespace works, but editors that use the schema report the whole file as wrong",
                    advice="write http://www.eprosima.com",
                    fix=fix("write the newer namespace", (value, "http://www.eprosima.com")),
                )
