"""A local number in C++ is added to before it has a value.

## What it finds
A number that a function of a C++ node declares without a value, and whose first use is `+=`, `-=`, `*=`, `/=`, `++` or
`--`, when nothing in its block gives it a value. The same for an array of numbers and its elements.

## Why it matters on a robot
Such a variable starts with whatever is on the stack. A debug build often finds zero there, the optimised build on the
robot does not: sums, means and angles are wrong by any amount, differently at each call.

## Bad
```cpp
double sum;
for (double range : ranges) { sum += range; }
```

## Good
```cpp
double sum = 0.0;
for (double range : ranges) { sum += range; }
```

## When to ignore it
When a macro that is not seen here gives it a value.

## References
- C++ standard, [dcl.init]: an automatic variable without an initialiser has an indeterminate value
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="unsafe", silent="only the compiler warns, with -Wall: may be used uninitialized")
def number_unset(robot: Robot) -> Iterator[Finding]:
    for node in robot.nodes.cpp:
        if robot.launch.workspace.is_vendored(node.source):
            continue
        for unset in node.unset:
            is_array = unset.declared.text != unset.name
            begun = f"{unset.declared.text} = {{}}" if is_array else f"{unset.name} = 0"
            yield finding(
                unset.used,
                f"{unset.name} has no value before this: the result is whatever was in memory, another at each call",
                advice=f"keep it from one call to the next, with {begun} at the beginning: as a member of the class, "
                "one for each signal, or static where all calls and objects may share it"
                if unset.is_kept
                else f"write {begun} where it is declared",
                related=[note(unset.declared, "declared without a value")],
                fix=fix(f"begin {unset.name} with 0", (unset.declared, begun))
                if not is_array and not unset.is_kept
                else None,
                severity=robot.nodes.lowered(node.source, "warning"),
            )
