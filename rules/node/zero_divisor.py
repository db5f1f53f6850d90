"""A node divides by a velocity that is 0 when the robot stops.

## What it finds
`/ msg->angular.z` and `/ msg->linear.x` in C++, `/ msg.angular.z` and `/ msg.linear.x` in Python, in functions that
compare the divisor with nothing. Measured velocities, by the name of their variable, are left out.

## Why it matters on a robot
A command to stop has only zeros, one to drive straight ahead has no rotation, and one to turn on the spot no speed. In
Python the ZeroDivisionError ends the node. In C++ the quotient is infinite, or NaN for 0 / 0: no comparison with a
limit holds it back, and converted to an integer for the motors it may be any number.

## Bad
```cpp
const double radius = msg->linear.x / msg->angular.z;
```

## Good
```cpp
const double curvature = std::abs(msg->linear.x) > 1e-3 ? msg->angular.z / msg->linear.x : 0.0;
```

## When to ignore it
When what sends the commands never sends a zero, and the quotient is checked where it is used.

## References
- IEEE 754: the quotient of a number and zero
- https://docs.python.org/3/library/exceptions.html#ZeroDivisionError
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import rule

ADVICE = "compare it with a small number before"
_WHEN = {"z": "to drive straight ahead, and to stop", "x": "to turn on the spot, and to stop"}


@rule("warning", symptoms=["ZeroDivisionError: float division by zero"])
def zero_divisor(robot: Robot) -> Iterator[Finding]:
    for found in nodes.zero_divisors(robot.nodes):
        yield finding(
            found.file.span_of(found.divisor),
            f"{found.name} is 0 in the command {_WHEN[found.name[-1]]}: the division raises, and "
            f"{nodes.end_of(robot.nodes.syntax(found.file), found.divisor)}",
            advice=ADVICE,
            severity=robot.nodes.lowered(found.file.source, "warning"),
        )
    for node in robot.nodes.cpp:
        for divisor, is_zero_too in node.divisors:
            move, stop = _WHEN[divisor[-1]].split(", and ")
            yield finding(
                divisor,
                f"{divisor} is 0 in the command {stop}, where 0 / 0 is NaN, and in the command {move}, where the "
                "quotient is infinite"
                if is_zero_too
                else f"{divisor} is 0 in the command {move}, and {stop}: the quotient is infinite, or no number at all",
                advice=ADVICE,
                severity=robot.nodes.lowered(node.source, "warning"),
            )
