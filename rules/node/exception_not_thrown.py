"""A C++ node makes an exception and does not throw it.

## What it finds
An exception of the standard library in a statement of its own, without `throw`. Once a source, with the other places.

## Why it matters on a robot
The statement makes an object and destroys it again. What was to end here goes on: with a pointer of the wrong type,
with an image whose format nobody knows, with a device that was not found. Nothing is logged.

## Bad
```cpp
if (device == nullptr) { std::runtime_error("no camera"); }
```

## Good
```cpp
if (device == nullptr) { throw std::runtime_error("no camera"); }
```

## When to ignore it
Never; what is not to be thrown can be removed.

## References
- C++ standard, [class.temporary]: a temporary object is destroyed at the end of the full expression
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="no statement was to run after it, and those that do run say something else")
def exception_not_thrown(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.unthrown(robot.nodes):
        yield finding(
            first,
            "This exception is made and not thrown: the code goes on as if nothing had happened",
            advice="write 'throw' before it",
            related=[note(each, "nor is this one") for each in others],
            severity=robot.nodes.lowered_if_vendored(first.span.source, "warning"),
        )
