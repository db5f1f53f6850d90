"""A parameter of ros2_control hardware that its source does not get, or takes for another value.

## What it finds
In `<ros2_control>`, beside a `<plugin>` whose C++ source is in the tree:

- parameters that `on_init` reads without a condition by `.at("...")`, or turns into a number, and that `<hardware>`
  does not give (error);
- parameters that no source of the tree names, where the source reads one of a similar name that is not given, also from
  a joint (warning), and other parameters that no source names (info);
- values that xacro writes as `True`, from a property, an argument of a macro or a YAML file, where the source compares
  them with `"true"` (warning; info where no source uses what it keeps of it).

Silent where the source hands all parameters on, and where `<hardware>` gets some from a macro.

## Why it matters on a robot
An exception in `on_init` keeps the hardware from being loaded: no controller finds its interfaces, or the whole
controller manager ends. A parameter under another name leaves the driver with its default, or with an empty text: the
wrong port, the wrong motor. A `True` that is taken for false turns an axis or a limit switch round.

## Bad
```xml
<plugin>winch_driver/Winch</plugin>
<param name="can_interface">can0</param>   <!-- info_.hardware_parameters["can"] -->
```

## Good
```xml
<plugin>winch_driver/Winch</plugin>
<param name="can">can0</param>
```

## When to ignore it
When another program reads the parameter from the description.

## References
- ros2_control, hardware_interface/hardware_info.hpp: `hardware_parameters`
- xacro, `get_boolean_value` and `eval_text`: a property `true` becomes the text `True`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import HardwareParameter


@rule("error", confidence="medium", symptoms=["stoi", "map::at", "Failed to initialize hardware"])
def hardware_parameter(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.hardware_parameters:
        yield finding(
            each.place,
            _message(each),
            advice=_advice(each),
            related=[
                note(
                    each.read, "the source reads it here" if each.kind != "unread" else "the source reads another one"
                ),
                *([note(each.value, "the value comes from here")] if each.value not in (None, each.place) else []),
            ],
            severity=_severity(each),
        )


def _message(each: HardwareParameter) -> str:
    if each.kind == "missing":
        more = f" and {len(each.others)} other{'s' if len(each.others) > 1 else ''}" if each.others else ""
        return f"{each.plugin} needs the parameter '{each.name}'{more}: without it the hardware is not loaded"
    if each.kind == "unread":
        return f"The source of {each.plugin} reads no parameter '{each.name}': the value has no effect"
    return (
        f"'{each.name}' is 'True' in the description, and {each.plugin} compares it with 'true': it is taken for false"
    )


def _advice(each: HardwareParameter) -> str:
    if each.kind == "missing":
        return "add the parameter to <hardware>"
    if each.kind == "unread":
        return f"give '{each.like}', which the source reads" if each.like else "remove the parameter"
    return "write ${str(...).lower()}, or use hardware_interface::parse_bool, which takes both"


def _severity(each: HardwareParameter) -> str | None:
    if each.kind == "missing":
        return None
    return "warning" if (each.kind == "boolean" and not each.is_idle) or each.like else "info"
