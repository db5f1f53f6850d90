"""Before= is used to make a unit stop first.

## What it finds
A service with `Before=` of another service, when it depends on that service (`Requires=`, `BindsTo=`) or is
stopped with it (`PartOf=`), and that service does not depend on it. One-shot services are exempt: they
prepare something for the other service or only hold a group together.

## Why it matters on a robot
The stop order is the exact reverse of the start order: with `Before=B`, the unit stops *after* B. A
controller that should first bring the wheels to a stop still sends commands when the driver below it is gone.
At boot, it starts before the driver that it requires.

## Bad
```ini
[Unit]
PartOf=base-driver.service
Before=base-driver.service
```

## Good
```ini
[Unit]
PartOf=base-driver.service
After=base-driver.service
```

## When to ignore it
When the unit must indeed start before the other one and stop after it, for example because it opens a
resource that the other one uses.

## References
- systemd.unit(5), "Before=, After=": "the ordering at shutdown is the inverse"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import Assignment
from bringup_lint.api.systemd import Unit

DEPENDS = ("Requires", "BindsTo", "PartOf")


@rule("warning", fix="unsafe", silent="the units stop in the order that they declare")
def before_for_shutdown_order(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        if unit.get("Type") == "oneshot":
            continue
        depends = {str(word): (key, word) for key in DEPENDS for word in unit.words(key)}
        for line in unit.assignments("Before"):
            for word in line.value.words():
                if word not in depends or not word.endswith(".service") or not line.span.source.judged:
                    continue
                other = robot.units.find(word, unit)
                if other is None or other.get("Type") == "oneshot" or robot.units.brings_in(other, unit.name):
                    continue
                key, where = depends[str(word)]
                yield finding(
                    word,
                    f"Before={word} makes {unit.name} start first and stop last, though it "
                    + (f"is {key}= of" if key == "PartOf" else f"{'requires' if key == 'Requires' else 'is bound to'}")
                    + f" {word}",
                    advice=f"write After={word}: a unit that starts later stops earlier",
                    related=[note(where, f"{key}= does not define an order")],
                    fix=_fix(unit, line, word),
                )


def _fix(unit: Unit, line: Assignment, word: Located) -> Fix:
    if any(unit.naming("After", word)):
        return fix(f"remove Before={word}", line.without(word))
    if line.value.split() == [word]:
        return fix("reverse the order", (line.key, "After"))
    return fix("reverse the order", line.without(word), (line.end, f"\nAfter={word}"))
