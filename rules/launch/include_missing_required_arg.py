"""A required argument of a launch file is not passed.

## What it finds
Includes of a file that declares an argument without a default, where the include does not pass it and nothing
before has set it. An include under a condition is a warning. Units, and compose services that are built from this
tree, are checked in the same way when they launch such a file.

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


@rule("error", symptoms=["Included launch description missing required argument"])
def include_missing_required_arg(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        for include in expansion.includes:
            if include.target is None or include.action.open:
                continue
            present = set(include.arguments) | include.known
            for declared in robot.launch.expansion(include.target).declared:
                needed = declared.file is include.target and not declared.conditions
                if not needed or declared.action.default is not None or declared.name in present:
                    continue
                if declared.before is not None or robot.launch.unknown_before(expansion, include):
                    continue
                yield finding(
                    include.action.file.span,
                    f"The required argument '{declared.name}' is not passed: launch aborts",
                    advice=f"pass '{declared.name}'",
                    related=[note(declared.action.span, "declared here without a default")],
                    chain=robot.provenance.chain_to(include.action.file.span, f"nothing passes '{declared.name}'"),
                    severity="warning" if include.conditions else None,
                )
    for command in robot.runners.launches:
        passed = {str(name) for name, _ in command.arguments}
        if command.file is None or not command.runner.certain:
            continue
        for declared in robot.launch.expansion(command.file).declared:
            own = declared.file is command.file and not declared.conditions and declared.before is None
            if own and declared.action.default is None and declared.name not in passed:
                yield finding(
                    command.target,
                    f"The required argument '{declared.name}' is not passed: launch refuses to start",
                    advice=f"pass {declared.name}:=",
                    related=[note(declared.action.span, "declared here without a default")],
                )
