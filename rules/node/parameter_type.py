"""A parameter is read as another type than it is declared with.

## What it finds
In C++ `get_parameter("x").as_double()`, `as_int()`, `as_bool()`, `as_string()` and `get_value<T>()`, outside every
`try`, of a parameter that the file declares with another type. In Python the field of another type of
`get_parameter('x').get_parameter_value()`. The type is that of the template argument, or of the default: `10` is an
integer, `10.0` a double.

## Why it matters on a robot
A parameter keeps the type with which it is declared, whatever a file gives it. In C++ the call throws
`ParameterTypeException`, and the node ends: at its start, or in the middle of a drive when only a callback asks. In
Python the field of the other type is empty: a speed limit of 0, a device without a name.

## Bad
```cpp
declare_parameter("rate", 10);
rclcpp::Rate rate(get_parameter("rate").as_double());
```

## Good
```cpp
declare_parameter("rate", 10.0);
rclcpp::Rate rate(get_parameter("rate").as_double());
```

## When to ignore it
When something sets the parameter undeclared and declares it anew with the other type.

## References
- rclcpp, parameter_value.hpp: `ParameterTypeException`
- rcl_interfaces, ParameterValue.msg
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

EMPTY = {"double": "0.0", "integer": "0", "bool": "False", "string": "an empty text"}


@rule("error", symptoms=["ParameterTypeException", "expected [double] got [integer]"])
def parameter_type(robot: Robot) -> Iterator[Finding]:
    for first, *others in nodes.misread_parameters(robot.nodes):
        a_type = f"{'an' if first.declared == 'integer' else 'a'} {first.declared}"
        end = (
            f"is always {EMPTY[first.read]}" if first.is_empty else "throws ParameterTypeException, and the node exits"
        )
        yield finding(
            first.place,
            f"'{first.name}' is declared as {a_type}: {first.call} {end}",
            advice=f"read it as {a_type}, or declare it with a default of the type that is read",
            related=[
                note(first.name, "declared here"),
                *(note(each.place, f"'{each.name}' is {each.declared}, too") for each in others),
            ],
            severity=robot.nodes.lowered(first.place.source, "error"),
        )
