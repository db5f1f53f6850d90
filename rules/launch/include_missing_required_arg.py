"""A required argument of a launch file is not passed.

## What it finds
Includes of a file that declares an argument without a default, where the include does not pass it and nothing before
has set it. Of files in packages that are not in the tree, those of common public packages are known. An include under
a condition is a warning. Units, and compose services that are built from this tree, are checked in the same way when
they launch such a file.

## Why it matters on a robot
launch checks the arguments when it reaches the include, and aborts.

## Bad
```xml
<include file="$(dirname)/localization.launch.xml"/>   <!-- declares map without a default -->
```

## Good
```xml
<include file="$(dirname)/localization.launch.xml">
  <arg name="map" value="$(find-pkg-share my_robot)/maps/lab.yaml"/>
</include>
```

## When to ignore it
Only for an include that is never reached without the argument, because a caller outside this tree always sets it.

## References
- launch, `IncludeLaunchDescription.execute`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Launching
from bringup_lint.api.launch import Unpassed
from bringup_lint.api.launch import not_passed
from bringup_lint.api.launch import unpassed


@rule(
    "error",
    symptoms=[
        "Included launch description missing required argument",
        'Required launch argument "*" (description: "*") was not provided',
        'Required launch argument "*" was not provided',
    ],
)
def include_missing_required_arg(robot: Robot) -> Iterator[Finding]:
    for declared, by in not_passed(robot.launch, robot.runners):
        related = [note(declared.action.span, "declared here without a default")]
        if isinstance(by, Launching):
            yield finding(
                by.target,
                f"The required argument '{declared.name}' is not passed: launch refuses to start",
                advice=f"pass {declared.name}:=",
                related=related,
            )
            continue
        yield finding(
            by.action.file.span,
            f"The required argument '{declared.name}' is not passed: launch aborts",
            advice=f"pass '{declared.name}'",
            related=related,
            chain=robot.provenance.chain_to(by.action.file.span, f"nothing passes '{declared.name}'"),
            severity="warning" if by.conditions else None,
        )
    for file in robot.launch.judged:
        for each in unpassed(robot.launch, file):
            where = each.instead.span if each.instead else each.include.action.file.span
            yield finding(
                where,
                missing(each),
                advice=f"pass '{each.name}'",
                chain=robot.provenance.chain_to(where, f"nothing passes '{each.name}'"),
                severity="warning" if each.include.conditions else None,
            )


def missing(each: Unpassed) -> str:
    if each.instead:
        return f"{each.target} takes no '{each.instead}', and its required '{each.name}' is not passed: launch aborts"
    return f"The required argument '{each.name}' of {each.target} is not passed: launch aborts"
