"""A value in a NetworkManager profile does not fit its key.

## What it finds
- a boolean other than `true`, `false`, `1` and `0`: `yes`, `no`, `on` and `off` are not booleans in keyfiles
- a number that is not one
- an unknown word of method, mode, band or key-mgmt
- an address that is not one, or name servers separated by commas instead of semicolons

## Why it matters on a robot
NetworkManager refuses a profile with an unknown word. It drops every other wrong value with one warning and uses the
default: `autoconnect=no` connects, `never-default=yes` makes a default route, and `dns=8.8.8.8,1.1.1.1` sets no name
server.

## Bad
```ini
[connection]
autoconnect=no
```

## Good
```ini
[connection]
autoconnect=false
```

## When to ignore it
Never: the value has no effect.

## References
- nm-settings(5), nm-settings-keyfile(5)
- GLib, `g_key_file_get_boolean()`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import wrong_value

CODES = (Code.BOOL, Code.NUMBER, Code.ENUM, Code.ADDRESS)
BOOLEANS = {"yes": "true", "on": "true", "no": "false", "off": "false"}


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "is not a valid value for the property",
        "property is invalid",
        "is not a valid Wi-Fi mode",
        "ignoring invalid IPv4 address",
        "ignoring invalid DNS server",
        "invalid setting: Key file contains key * which has a value that cannot be interpreted",
    ],
)
def invalid_value(robot: Robot) -> Iterator[Finding]:
    for problem in robot.networkmanager.remarks(*CODES):
        consequence = "refuses the profile" if problem.fatal else "ignores the line, the default applies"
        message = f"{problem.known.name} takes {problem.detail}, not '{problem.where}': NetworkManager {consequence}"
        right = BOOLEANS.get(str(problem.where).lower()) if problem.code == Code.BOOL else None
        yield wrong_value(problem.where, message, right, f"write {problem.detail}")
