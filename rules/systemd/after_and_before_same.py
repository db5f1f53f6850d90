"""A unit lists another unit in both After= and Before=.

## What it finds
A unit, drop-ins included, that names the same other unit in `After=` and in `Before=`.

## Why it matters on a robot
The two orders form a cycle. With `Requires=` or `BindsTo=` between the units, neither starts ("Transaction
order is cyclic"). Without it, systemd drops one of them from the boot. The second line is often added in the
belief that `Before=` controls the stop order, but the stop order is always the reverse of the start order.

## Bad
```ini
[Unit]
After=perception.service
PartOf=perception.service
Before=perception.service
```

## Good
```ini
[Unit]
After=perception.service
PartOf=perception.service
```

## When to ignore it
Never: systemd cannot satisfy both orders.

## References
- systemd.unit(5), "Before=, After="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

DEPENDS = ("Requires", "BindsTo", "PartOf", "Requisite", "Wants")


@rule(
    "error",
    fix="unsafe",
    symptoms=["Unable to break cycle starting with", "Found ordering cycle on", "Transaction order is cyclic"],
)
def after_and_before_same(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        before = {str(word): word for word in unit.words("After")}
        for line in unit.assignments("Before"):
            for word in line.value.words():
                if word not in before or word == unit.name or not line.span.source.judged:
                    continue
                depends = any(word in unit.words(key) for key in DEPENDS)
                yield finding(
                    word,
                    f"{unit.name} must start both after and before {word}: systemd cannot "
                    "do both, and drops one unit or starts neither",
                    advice=f"keep After={word} if {unit.name} needs it: {unit.name} then also stops "
                    "first, because the stop order is the reverse of the start order",
                    related=[note(before[word], "the opposite order")],
                    fix=fix(f"remove Before={word}", line.without(word), safe=depends),
                )
