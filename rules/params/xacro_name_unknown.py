"""A robot description uses a name that xacro does not know.

## What it finds
In files for xacro: calls of macros that nothing defines, with parameters that the macro does not have or without those
that it needs, attributes that xacro needs and an element lacks, and properties in `${...}` that nothing defines. Where
more may be defined in files outside of the tree, or in a condition, and for arguments in `$(arg ...)`, only what is
misspelt. Attributes that xacro ignores because they are misspelt are found, too. A file that no launch file and no
other description names is a warning.

## Why it matters on a robot
xacro ends with the error and prints no description. Launch stops with it, and nothing of the launch file starts.

## Bad
```xml
<xacro:property name="wheel_radius" value="0.1"/>
<cylinder radius="${wheel_radus}" length="0.05"/>
```

## Good
```xml
<xacro:property name="wheel_radius" value="0.1"/>
<cylinder radius="${wheel_radius}" length="0.05"/>
```

## When to ignore it
When the file is a part, and a description in another repository defines the name before it includes the file.

## References
- https://github.com/ros/xacro/wiki
- xacro 2.1.1, `handle_macro_call` and `check_attrs`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import XacroRefused


@rule(
    "error",
    symptoms=[
        "name '*' is not defined",
        "unknown macro name: xacro:*",
        'Invalid parameter "*"',
        "Undefined parameters [*]",
        "Not enough blocks",
        "missing attribute '*'",
    ],
)
def xacro_name_unknown(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.xacro_refused:
        ends = "it ignores it" if each.what == "ignored" else "it ends, and launch stops"
        yield finding(
            each.where,
            f"{_what(each)}: {ends}",
            advice=_advice(each),
            related=[
                *([note(each.other, "defined here")] if each.other is not None else []),
                *(note(place, "here, too") for place in each.again[:10]),
            ],
            severity="warning" if each.what == "ignored" or not each.used else None,
        )


def _what(refused: XacroRefused) -> str:
    match refused.what:
        case "macro":
            return f"xacro knows no macro '{refused.name}'"
        case "parameter":
            return f"The macro '{refused.detail}' has no parameter '{refused.name}' for xacro"
        case "missing":
            return f"xacro gets no parameter '{refused.name}', which the macro '{refused.detail}' needs"
        case "block":
            return f"xacro gets no block, which the macro '{refused.name}' needs"
        case "attribute":
            return f"xacro finds no attribute '{refused.name}' in <{refused.detail}>"
        case "ignored":
            return f"xacro knows no attribute '{refused.name}' of <{refused.detail}>"
        case "name":
            return f"xacro knows no property '{refused.name}'"
    return f"xacro knows no argument '{refused.name}'"


def _advice(refused: XacroRefused) -> str:
    if refused.what == "attribute":
        return f"write {refused.name} instead of {refused.near}" if refused.near else f"add {refused.name}"
    if refused.near:
        return f"did you mean {refused.near}?"
    match refused.what:
        case "missing":
            return "give it in the call, or give it a default in the macro"
        case "block":
            return "put the element into the call"
    return "define it, or correct the name"
