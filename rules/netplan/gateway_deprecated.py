"""gateway4 and gateway6 are deprecated.

## What it finds
`gateway4` or `gateway6`. `0.0.0.0` and `::` are no gateway: there is no route to write then.

## Why it matters on a robot
Both keys still work, with a warning at every run, but they hide conflicts: two of them in two files are two
default routes. A route shows its metric and table.

## Bad
```yaml
gateway4: 10.0.0.1
```

## Good
```yaml
routes: [{to: default, via: 10.0.0.1}]
```

## When to ignore it
If the robot runs Ubuntu 18.04 or 20.04, whose netplan may not know `to: default`.

## References
- netplan YAML reference, "gateway4, gateway6"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.netplan import Interface
from bringup_lint.api.yaml import Node
from bringup_lint.api.yaml import Scalar


@rule("info", fix="safe", symptoms=["`gateway4` has been deprecated, use default routes instead"])
def gateway_deprecated(robot: Robot) -> Iterator[Finding]:
    for interface in robot.netplan.interfaces:
        for key in ("gateway4", "gateway6"):
            for name, value in interface.entries(key):
                if _is_unspecified(value):
                    yield _of_no_gateway(name, value)
                    continue
                yield finding(
                    name.value,
                    f"{key} is deprecated: write a default route",
                    advice=f"routes: [{{to: default, via: {getattr(value, 'value', '...')}}}]",
                    fix=_as_route(interface, name, value),
                )


def _is_unspecified(value: Node) -> bool:
    """Whether an address stands for none (RFC 1122 and RFC 4291), or is empty."""
    return isinstance(value, Scalar) and value.value in ("0.0.0.0", "::", "")


def _of_no_gateway(name: Scalar, value: Node) -> Finding:
    return finding(
        name.value,
        f"{value.span.text} is not a gateway: nothing beyond the networks of this interface is reached through it",
        severity="warning" if isinstance(value, Scalar) and value.value else None,
        advice="remove the line, or write the address of the router: routes: [{to: default, via: ...}]",
    )


def _as_route(interface: Interface, name: Scalar, value: Node) -> Fix | None:
    """Put a route in the place of the key; only where no other routes are."""
    if any(True for _ in interface.entries("routes")) or not hasattr(value, "value"):
        return None
    if (
        sum(1 for key in ("gateway4", "gateway6") for _ in interface.entries(key)) > 1
        or name.span.line != value.span.line
    ):
        return None
    between = name.span.source.text[name.span.end : value.span.start]
    if between.strip("\"' \t") != ":" or not value.span.text:
        return None  # an anchor would be lost, and an alias has no text of its own
    whole = name.span.source.span(name.span.start, value.span.end)
    return fix("write a default route", (whole, f"routes: [{{to: default, via: {value.span.text}}}]"))
