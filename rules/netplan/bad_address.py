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
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["is missing /prefixlength", "malformed address", "invalid prefix length in address"])
def bad_address(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(Code.ADDRESS, Code.PREFIX_LENGTH):
        length = problem.code == Code.PREFIX_LENGTH
        advice = "append the prefix length, such as /24" if length else "correct the address"
        message = f"netplan generates nothing: '{problem.where}' {problem.detail}"
        yield finding(problem.where, message, advice=advice)
