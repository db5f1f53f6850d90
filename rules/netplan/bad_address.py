"""netplan cannot read an address.

## What it finds
An address that netplan does not accept:
- an interface address without a prefix length, or with one that is too long
- a name server or gateway with a prefix length
- leading zeros in an IPv4 address
- text that is not an address, including in routes

## Why it matters on a robot
`netplan generate` stops at the first error and writes nothing: one missing `/24` takes the whole robot off
the network.

## Bad
```yaml
addresses: [10.0.0.10]
```

## Good
```yaml
addresses: [10.0.0.10/24]
```

## When to ignore it
Never: `netplan generate` stops here and configures nothing.

## References
- netplan YAML reference, "addresses"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import explained

MESSAGE = "netplan generates nothing: '{where}' {detail}"
TEXTS: dict[str, tuple[str, str]] = {
    Code.ADDRESS: (MESSAGE, "correct the address"),
    Code.PREFIX_LENGTH: (MESSAGE, "append the prefix length, such as /24"),
}


@rule("error", symptoms=["is missing /prefixlength", "malformed address", "invalid prefix length in address"])
def bad_address(robot: Robot) -> Iterator[Finding]:
    yield from explained(robot.netplan.problems(*TEXTS), TEXTS)
