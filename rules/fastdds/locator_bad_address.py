"""A Fast DDS locator is not an address.

## What it finds
A locator that cannot be used:
- **error**: an address with a number above 255, an address followed by a port or prefix, or an IPv4 address
  in an IPv6 locator.
- **warning**: a UDP port above 65535, which the library accepts without a message.

Host names are valid if they can be resolved.

## Why it matters on a robot
For an error the library ignores the whole file and uses its defaults: multicast discovery, no peers, no
limits. The exit status is 0, and only a line on the terminal reports it. With a wrong port, the other machine
is never reached.

## Bad
```xml
<address>10.0.0.300</address>
```

## Good
```xml
<address>10.0.0.30</address>
```

## When to ignore it
Never: the library does not use such a locator.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.addresses import HIGHEST_PORT
from bringup_lint.api.schema import Code


@rule("error", symptoms=["Failed to parse UDPv4 locator's address tag"])
def locator_bad_address(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.ADDRESS):
        yield finding(
            remark.where,
            f"'{remark.where}' is not a valid address ({remark.detail}): the whole file is ignored, the robot runs "
            "with defaults",
            advice="write one plain address, with the port in its own element",
        )
    for port in robot.dds.locator_ports():
        if port.isdecimal() and int(port[:9]) > HIGHEST_PORT:
            message = f"Port {port} does not exist: the library accepts the locator, but nothing ever arrives there"
            yield finding(port, message, advice="write a port from 1 to 65535", severity="warning")
