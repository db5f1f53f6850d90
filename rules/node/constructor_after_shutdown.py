"""The constructor of a node goes on after it has shut the context down.

## What it finds
`rclpy.shutdown()` in the constructor of a Python node that neither returns nor raises after it, and then makes a
publisher, a subscription, a service, a client or a timer; or that returns, where the program spins the node without
asking `rclpy.ok()`. It is an info where the branch, a method that it calls, or the handler around it logs or prints
anything: the program ends all the same, and the log has the cause beside the traceback. In C++ `rclcpp::shutdown()` in
a constructor that then makes one of these, or in a method without an answer that such a constructor calls.

## Why it matters on a robot
`shutdown()` ends nothing: it returns. The constructor goes on without the device that it did not find, and the next
entity, or `rclpy.spin()`, raises an error about the context, which is all that the log then says. A program in C++
aborts where `main()` does not catch it: a core dump instead of an end with a status.

## Bad
```python
if not self.port:
    self.get_logger().error('no port')
    rclpy.shutdown()
self.timer = self.create_timer(0.1, self.read)
```

## Good
```python
if not self.port:
    raise RuntimeError('no port')
self.timer = self.create_timer(0.1, self.read)
```

## When to ignore it
Never: raise an exception that names the cause, in C++ with a handler in `main()` that returns a failure.

## References
- tried with rclpy of Jazzy
- rclcpp, subscription_base.cpp, service.hpp, timer.cpp: each throws when rcl refuses the context
- rclpy, `shutdown`; rcl, guard_condition.c and node.c: both refuse a context that is not valid
"""

from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

SAID = {True: ", and the log has a traceback, too", False: ", and the log does not say what failed", None: ""}
"""By whether what failed is logged."""


@rule("warning", symptoms=["either rcl_init() was not called or rcl_shutdown() was called"])
def constructor_after_shutdown(robot: Robot) -> Iterator[Finding]:
    yield from _in_python(robot)
    for driver in robot.nodes.drivers:
        shut = (each for each in driver.shut_contexts if each.owner is not None)
        for first in islice(shut, 1):
            yield finding(
                first.shutdown,
                f"The constructor of {first.owner} goes on after this: {first.name}() throws, because the context is "
                "shut down, and the process aborts where main() does not catch it",
                advice="throw an exception that names the cause, and catch it in main(), which returns EXIT_FAILURE",
                related=[note(first.behind, "throws")],
                severity=robot.nodes.lowered_if_vendored(driver.source, "warning"),
            )


def _in_python(robot: Robot) -> Iterator[Finding]:
    for file, node in robot.nodes.node_classes:
        syntax = robot.nodes.syntax(file)
        found = [("goes on", each) for each in nodes.shut_constructors(syntax, node)]
        found += [("only returns", each) for each in nodes.spun_after(syntax, node)]
        for what, each in found:
            says = SAID[each.is_logged]
            yield finding(
                file.span_of(each.shutdown),
                f"The constructor {what} after this: {each.name}() raises, as the context is shut down{says}",
                advice="raise an exception that names the cause instead",
                related=[note(file.span_of(each.made), "raises")],
                severity="info" if each.is_logged else robot.nodes.lowered_if_vendored(file.source, "warning"),
            )
