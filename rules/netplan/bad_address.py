"""An address that netplan cannot read.

## What it finds
An address without prefix length, with a prefix length that is too long, with leading zeros, or that is no
address at all; the same for gateways, name servers and routes. Name servers and gateways stand without a
prefix length.

## Why it matters on a robot
`netplan generate` stops there and writes nothing: one missing `/24` takes the whole robot off the network.

## Bad
```yaml
addresses: [10.0.0.10]
```

## Good
```yaml
addresses: [10.0.0.10/24]
```

## References
- netplan YAML reference, "addresses"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["is missing /prefixlength", "malformed address", "invalid prefix length in address"])
def bad_address(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems("bad-address"):
        advice = "append the prefix length, such as /24" if "prefix length" in problem.detail else "correct the address"
        message = f"netplan generates nothing: '{problem.where}' {problem.detail}"
        yield finding(problem.where, message, advice=advice)
