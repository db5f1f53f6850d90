"""A C++ node throws a text or a number instead of an exception.

## What it finds
`throw` of a text, `errno`, `strerror()` or a number, outside every `try` of its function, in a package in which no
handler takes such a thing. Once a source, with the other places. It is an info where the package has no handler that
would take an exception either.

## Why it matters on a robot
`catch (const std::exception &)`, around a callback, in the component manager and in lifecycle transitions, does not
take it. The process ends in `std::terminate`, in a container with all its nodes, and the log has no word of the reason:
"terminate called after throwing an instance of 'char const*'".

## Bad
```cpp
if (ready == 0) { throw "select timeout"; }
```

## Good
```cpp
if (ready == 0) { throw std::runtime_error("select timeout"); }
```

## When to ignore it
When a program that uses the package as a library takes it.

## References
- C++ Core Guidelines, E.14: use purpose-designed user-defined types as exceptions
- C++ standard, [except.handle]: a handler takes its own type and what is derived from it
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["terminate called after throwing an instance of 'char const*'"])
def throw_not_exception(robot: Robot) -> Iterator[Finding]:
    for (first, *others), is_handled in nodes.thrown(robot.nodes):
        yield finding(
            first.place,
            f"This throws {first.kind}, which no handler of std::exception takes: the process ends in an abort",
            advice="throw std::runtime_error with the text",
            related=[note(each.place, "the same here") for each in others],
            severity=robot.nodes.lowered_if_vendored(first.place.source, "warning" if is_handled else "info"),
        )
