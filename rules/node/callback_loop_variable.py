"""Callbacks that a loop makes all use its last value.

## What it finds
In Python: a `lambda` handed to `create_subscription()`, `create_timer()`, `create_service()`, `add_done_callback()` and
the like in a loop or comprehension, whose body uses the variable of the loop, or what the loop computes from it. Silent
where a default of the lambda keeps the value, where a condition on the variable or a `break` lets the loop make one
callback, and where something in the loop waits or spins. It is an info where the value is only logged.

## Why it matters on a robot
A lambda looks its variables up when it runs. That is after the loop, so that every callback sees the last robot, wheel
or camera: all messages are booked on one of them, and the others seem to send nothing. With one entry in the list, as
on the desk, it works.

## Bad
```python
for side in ('left', 'right'):
    self.create_subscription(Float64, f'{side}/speed', lambda msg: self.on_speed(side, msg), 10)
```

## Good
```python
for side in ('left', 'right'):
    self.create_subscription(Float64, f'{side}/speed', lambda msg, side=side: self.on_speed(side, msg), 10)
```

## When to ignore it
When the list never has more than one entry.

## References
- https://docs.python.org/3/faq/programming.html, "Why do lambdas defined in a loop with different values all return the
  same result?"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="the callbacks run, for another robot or part than the message is from")
def callback_loop_variable(robot: Robot) -> Iterator[Finding]:
    for file in robot.nodes.judged:
        found = list(nodes.late_bound(robot.nodes.syntax(file)))
        if not found:
            continue
        first, *others = sorted(found, key=lambda each: each.is_logged)
        name = first.use.id
        end = "the log always names the same one" if first.is_logged else "all of them act for the same one"
        yield finding(
            file.span_of(first.use),
            f"'{name}' has its last value in every callback of the loop: {end}",
            advice=f"keep the value in a default: lambda ..., {name}={name}: ...",
            related=[
                note(file.span_of(first.loop), f"each turn gives '{name}' another value"),
                *(note(file.span_of(each.use), "here, too") for each in others[:10]),
            ],
            severity="info" if first.is_logged else robot.nodes.lowered(file.source, "error"),
        )
