"""One unit in both After= and Before=.

## What it finds
A unit, drop-ins included, that names the same other unit in `After=` and in `Before=`.

## Why it matters on a robot
Both orders at once are a cycle of two: with `Requires=` or `BindsTo=` between them neither unit starts
("Transaction order is cyclic"), without it systemd leaves one of them out. The second line is often added
because of the belief that `Before=` controls the stop order; a stop is the reverse of the start already.

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

## References
- systemd.unit(5), "Before=, After="
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

DEPENDS = ("Requires", "BindsTo", "PartOf", "Requisite", "Wants")


@rule("error", fix="safe", symptoms=["Transaction order is cyclic", "Found ordering cycle on"])
def after_and_before_same(robot: Robot):
    for unit in robot.units.judged:
        before = {str(word): word for word in unit.words("After")}
        for line in unit.assignments("Before"):
            for word in line.value.words():
                if word not in before or word == unit.name or not line.span.source.judged:
                    continue
                depends = any(word in unit.words(key) for key in DEPENDS)
                yield finding(
                    word,
                    f"{unit.name} is to start both after and before {word}: systemd cannot "
                    "do both and leaves a unit out, or starts none",
                    advice=f"keep After={word} if {unit.name} needs it: it already stops "
                    "first, because a stop is the reverse of the start",
                    related=[note(before[word], "the opposite order")],
                    fix=fix(f"drop Before={word}", line.without(word), safe=depends),
                )
