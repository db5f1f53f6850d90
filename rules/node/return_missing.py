"""A C++ function that owes a value ends without a return.

## What it finds
A function with a type, in a C++ source of a node, whose end is reached: it holds no `return` at all, its last statement
is no `return`, or a branch, a loop or a handler at its end is left without one. `throw`, endless loops, and calls and
macros that may never come back are no such end. It is an info where the conditions may be all that there are, and in a
function that nothing of the package calls.

## Why it matters on a robot
GCC only warns. To reach the end of such a function is undefined behaviour: with `-O2` (`RelWithDebInfo`, the Debian
packages) GCC 8 and newer leave out the end of the function, and the program runs on into whatever code follows: it
crashes, or does what nobody asked for. Without optimisation the caller gets what happened to be in the register, and
destroys a string, a vector or a pointer that was never made.

## Bad
```cpp
bool Arm::move_to(double angle)
{
  publisher_->publish(command(angle));
}
```

## Good
```cpp
bool Arm::move_to(double angle)
{
  publisher_->publish(command(angle));
  return true;
}
```

## When to ignore it
When the condition that is left over can never happen; say so with an exception.

## References
- C++ standard, [stmt.return]: "Flowing off the end of a function [...] results in undefined behavior"
- https://gcc.gnu.org/gcc-8/porting_to.html, "-Wreturn-type is enabled by default"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", silent="only the compiler warns: control reaches end of non-void function")
def return_missing(robot: Robot) -> Iterator[Finding]:
    for source, found, is_called in nodes.missing_returns(robot.nodes):
        when = f" {found.when}" if found.when else ""
        is_unlikely = found.is_open or not is_called or robot.launch.workspace.is_vendored(source)
        severity = "info" if is_unlikely else "warning" if found.when else "error"
        yield finding(
            found.name,
            f"{found.function}() ends without a return{when}: undefined behaviour, with -O2 it runs into other code",
            advice="return a value at the end of the function, or throw",
            related=[note(found.left, "left without a return")] if found.left is not None else [],
            severity=robot.nodes.lowered(source, severity),
        )
