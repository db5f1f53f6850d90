"""A Fast DDS locator that is no address.

## What it finds
An address with a number above 255, with a port or prefix behind it, or an IPv4 address in an IPv6
locator; and, as a warning, a UDP port above 65535, which the library takes silently. Host names are
fine when they can be resolved.

## Why it matters on a robot
The library ignores the whole file and goes on with its defaults, exit status 0: multicast discovery, no
peers, no limits. Only a line on the terminal tells.

## Bad
```xml
<address>10.0.0.300</address>
```

## Good
```xml
<address>10.0.0.30</address>
```

## References
- Fast DDS 2.14.5, tried with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["Failed to parse UDPv4 locator's address tag"])
def locator_bad_address(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.ADDRESS):
        yield finding(
            remark.where,
            f"'{remark.where}' is no address ({remark.detail}): the whole file is ignored, the robot runs "
            "with defaults",
            advice="write one plain address, with the port in an element of its own",
        )
    for port in robot.dds.locator_ports():
        if port.isdigit() and int(port[:9]) > 65535:
            message = f"Port {port} does not exist: the locator is taken, and nothing ever arrives there"
            yield finding(port, message, advice="write a port from 1 to 65535", severity="warning")
