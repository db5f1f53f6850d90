"""netplan rejects a value or the shape of an entry.

## What it finds
A value that netplan's own checks reject:
- a word that is not one of those allowed, or a number out of range
- a scalar where a mapping or a sequence is expected
- a route without destination, or an incomplete tunnel
- a port in two bridges

Addresses, renderers, versions, VLANs and Wi-Fi have their own rules.

## Why it matters on a robot
`netplan generate` stops at the first such value and writes nothing.

## Bad
```yaml
ethernets:
  eth0:
    dhcp4: enabled
```

## Good
```yaml
ethernets:
  eth0:
    dhcp4: true
```

## When to ignore it
Never: `netplan generate` stops here and configures nothing.

## References
- netplan YAML reference
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.netplan import PlanCode
from bringup_lint.api.schema import Code

CODES = (
    Code.SHAPE,
    Code.VALUE,
    Code.NAME,
    PlanCode.TYPE_CHANGED,
    PlanCode.TWO_MASTERS,
    PlanCode.DUPLICATE_SSID,
    PlanCode.ROUTE,
    PlanCode.ROUTE_FAMILIES,
    PlanCode.INCOMPLETE,
    PlanCode.SECRET,
)
SHAPES = {
    "mapping": "a mapping (check the indentation)",
    "sequence": "a sequence",
    "scalar": "a single value",
}


def _explain(code: str, where: str, detail: str) -> tuple[str, str]:
    """How to describe a problem, and what to do about it."""
    if code == Code.SHAPE:
        return f"{SHAPES[detail]} is expected here", f"write {SHAPES[detail]}"
    if code == PlanCode.TYPE_CHANGED:
        return f"'{where}' is already one of the {detail}", "use one device type for one name"
    if code == PlanCode.TWO_MASTERS:
        return f"'{where}' already belongs to {detail}", "a port can belong to only one: remove it here"
    if code == PlanCode.DUPLICATE_SSID:
        return f"the access point '{where}' appears twice", "merge the two"
    if code in (PlanCode.ROUTE, PlanCode.ROUTE_FAMILIES, PlanCode.INCOMPLETE):
        return detail, "complete it"
    if code == PlanCode.SECRET:
        return "this is not a WireGuard key", "write the whole base64 key, or the path of a file that contains it"
    return f"'{where}' {detail}", "correct the value"


@rule("error", symptoms=["Error in network definition"])
def invalid_value(robot: Robot) -> Iterator[Finding]:
    for problem in robot.netplan.problems(*CODES):
        where = problem.where
        text = where if isinstance(where, Located) else where.text.partition("\n")[0]
        message, advice = _explain(problem.code, text, problem.detail)
        secrets = [where] if problem.code == PlanCode.SECRET else []
        yield finding(where, f"netplan generates nothing: {message}", advice=advice, secrets=secrets)
