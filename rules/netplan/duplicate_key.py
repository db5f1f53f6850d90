"""A key appears twice in one mapping.

## What it finds
The same key twice in one YAML mapping of a netplan file: an interface, a device type or a setting.

## Why it matters on a robot
Netplan does not report it. It uses the last value of a repeated setting, and merges two blocks of one
interface. An address that should replace another one is added to it.

## Bad
```yaml
ethernets:
  eth0:
    dhcp4: true
  eth0:
    addresses: [10.0.0.10/24]
```

## Good
```yaml
ethernets:
  eth0:
    dhcp4: false
    addresses: [10.0.0.10/24]
```

## When to ignore it
Never: the file does not show which value applies. Merging the two blocks by hand does not change what netplan
does.

## References
- YAML 1.2.2, section 3.2.1.3: keys of a mapping are unique
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

_REFUSED = ("primary", "path-cost", "port-priority")
"""Keys whose second setting netplan does not take."""


@rule("error", symptoms=["duplicate map entry", "Duplicate access point SSID"])
def duplicate_key(robot: Robot) -> Iterator[Finding]:
    for file in robot.netplan.files:
        if file.embedded:
            continue
        for first, again in file.yaml.duplicates:
            yield finding(
                again.value,
                f"Duplicate key '{again.value}': "
                + (
                    "netplan refuses the file"
                    if again.value in _REFUSED
                    else "netplan gives no warning, keeps the last of single values and merges mappings"
                ),
                advice="merge the two",
                related=[note(first.value, "the first one")],
            )
