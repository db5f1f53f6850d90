"""A Cyclone DDS setting has moved or is deprecated.

## What it finds
An element that the target version accepts only with a warning: a deprecated one such as
`NetworkInterfaceAddress`, an older name, or a setting that has moved to another group.

## Why it matters on a robot
Every process logs a warning at each start. The next version of the library may refuse the file, and then no
node starts.

## Bad
```xml
<General>
  <NetworkInterfaceAddress>eth0</NetworkInterfaceAddress>
</General>
```

## Good
```xml
<General>
  <Interfaces>
    <NetworkInterface name="eth0"/>
  </Interfaces>
</General>
```

## When to ignore it
If the same file must also work with an older version of the library that knows only the old name.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library; 0.9.1
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import can_be_renamed
from bringup_lint.api.cyclonedds import has_address
from bringup_lint.api.cyclonedds import interfaces_instead
from bringup_lint.api.dds import renamed
from bringup_lint.api.schema import Code


@rule(
    "warning",
    fix="safe",
    symptoms=["deprecated element", "deprecated alias", "setting moved to", "settings moved to"],
)
def deprecated_element(robot: Robot) -> Iterator[Finding]:
    for configuration, remark in robot.dds.remarks(Code.DEPRECATED, Code.ALIAS, Code.MOVED):
        library = robot.dds.cyclonedds
        change = None
        if remark.code == Code.MOVED:
            place = remark.detail.removeprefix("CycloneDDS/")
            message, advice = (
                f"{remark.word} has moved in {library}: it still works, with a warning",
                f"write it as {place}",
            )
        elif remark.code == Code.ALIAS:
            message, advice = f"{remark.word} is the old name of {remark.detail}", f"write {remark.detail}"
            if can_be_renamed(configuration, remark.word, remark.known):
                change = fix(f"rename to {remark.detail}", *renamed(remark.word, remark.detail))
        else:
            message, advice = (
                f"{remark.word} is deprecated in {library}",
                "remove it, or use its replacement",
            )
            if remark.known.name == "NetworkInterfaceAddress":
                key = "address" if has_address(configuration, remark) else "name"
                advice = f'write <Interfaces><NetworkInterface {key}="..."/></Interfaces>'
                change = interfaces_instead(configuration, remark)
        yield finding(remark.word, message, advice=advice, fix=change)
