"""A wildcard block overrides the block of a specific node.

## What it finds
A block with a wildcard (`/**`) after the block of a node that it also matches, with a different value for one of
the parameters.

## Why it matters on a robot
The last matching block applies, not the most specific one: the node runs with the general value.

## Bad
```yaml
motors:
  ros__parameters: {rate: 50}
/**:
  ros__parameters: {rate: 10}
```

## Good
```yaml
/**:
  ros__parameters: {rate: 10}
motors:
  ros__parameters: {rate: 50}
```

## When to ignore it
When the wildcard block is meant as an override for all nodes, for example in a file for a test bench.

## References
- rclcpp, `parameter_map_from`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import params
from bringup_lint.api import rule


@rule("warning", silent="rcl takes the later block without a message")
def wildcard_overrides_specific(robot: Robot) -> Iterator[Finding]:
    for file in robot.params.judged:
        if not file.accepted:
            continue
        for specific, general in params.taken_back(file):
            yield finding(
                general.key,
                f"'{general.block.name}' comes last and sets '{general.name}' of {specific.block.name} to "
                f"{general.text} instead of {specific.text}",
                advice=f"move the block '{general.block.name}' to the top of the file",
                related=[note(specific.key, "this value is lost")],
            )
