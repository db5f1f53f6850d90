"""A rule contains the same match twice.

## What it finds
The same key, operator and value twice on one line, also with its alternatives in another order. Twice the kernel name,
the subsystem or the action is info: no other attribute can have been meant.

## Why it matters on a robot
One of the two was probably meant to be another attribute, so the rule matches more devices than it should.

## Bad
```udev
ATTRS{idVendor}=="0403", ATTRS{idVendor}=="0403", SYMLINK+="robot/imu"
```

## Good
```udev
ATTRS{idVendor}=="0403", ATTRS{idProduct}=="6001", SYMLINK+="robot/imu"
```

## When to ignore it
If a generator writes the rules and the repeated match is known to be harmless: udev only compares it twice.

## References
- `udevadm verify`: duplicate expressions
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.udev import Token


@rule("warning", fix="safe", symptoms=["duplicate expressions"])
def duplicate_match(robot: Robot) -> Iterator[Finding]:
    for rule_line in robot.udev.judged:
        seen: dict[tuple[object, ...], Token] = {}
        for token in rule_line.line.tokens:
            said = (token.name, token.operator, token.prefix, frozenset(token.alternatives))
            if token.is_match and token.key not in ("PROGRAM", "IMPORT") and said in seen:
                yield finding(
                    token.span,
                    f'{token.name}{token.operator}"{token.value}" appears twice on this line',
                    advice="delete it, or write the attribute that you meant",
                    related=[note(seen[said].span, "the first one")],
                    severity=None if token.attribute else "info",
                    fix=fix("delete the second one", *rule_line.without(token)),
                )
            seen.setdefault(said, token)
