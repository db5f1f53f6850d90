"""A launch file declares an argument twice, with two defaults.

## What it finds
`DeclareLaunchArgument` or `<arg>` for an argument that the same file has already declared with another default, where
launch comes to both without a condition. An argument that nothing reads is for launch/unused-arg.

## Why it matters on a robot
A declaration gives its default to an argument that has no value yet. The first one does; the second one finds the value
and keeps it, without a message. Whoever changes the second default, or reads it, sees a value that no robot ever has.

## Bad
```xml
<arg name="use_sim_time" default="false"/>
<arg name="use_sim_time" default="true"/>
```

## Good
```xml
<arg name="use_sim_time" default="true"/>
```

## When to ignore it
Never: delete the declaration that does not apply.

## References
- launch, `DeclareLaunchArgument.execute`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="launch keeps the first default without a message")
def arg_declared_twice(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        said = set()
        own = robot.launch.expansion(file)
        is_alone = not own.open and len(own.files) == 1 and not file.reads_all
        for each in own.declared:
            first, default = _before(each), launch.literal(each.action.default)
            if each.file is not file or each.name in said or first is None or default is None or default == first:
                continue
            if is_alone and all(argument.name != each.name for argument in file.reads):
                continue
            said.add(each.name)
            yield finding(
                default,
                f"'{each.name}' is declared above with the default '{first}', which launch keeps: the default "
                f"'{default}' never applies",
                advice="keep one of the two declarations",
                related=[note(first, "declared here first")],
            )


def _before(declared: launch.Declared) -> Located | None:
    """The default that an argument already has from the same file, in any case."""
    before = declared.before
    if before is None or not before.declared or declared.conditions:
        return None
    return launch.literal(before.value) if before.origin.source is declared.file.source else None
