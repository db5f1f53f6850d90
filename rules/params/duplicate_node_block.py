"""A node has two blocks in one file.

## What it finds
The same node key twice in one parameter file.

## Why it matters on a robot
rcl merges the blocks, and the later value applies. Somebody who edits the first block sees no effect.

## Bad
```yaml
motors:
  ros__parameters: {rate: 50}
motors:
  ros__parameters: {port: /dev/robot/motors}
```

## Good
```yaml
motors:
  ros__parameters: {rate: 50, port: /dev/robot/motors}
```

## When to ignore it
When the file is assembled from parts, and a later part is meant to override an earlier one.

## References
- rcl_yaml_param_parser, `find_node`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import Block


@rule("info", silent="both blocks are read without a message")
def duplicate_node_block(robot: Robot) -> Iterator[Finding]:
    for file in robot.params.judged:
        seen: dict[str, Block] = {}
        for block in file.blocks:
            first = seen.setdefault(block.name, block)
            if first is not block:
                yield finding(
                    block.key,
                    f"'{block.name}' has a second block here: rcl merges the two, and the later value applies",
                    advice="merge them",
                    related=[note(first.key, "the first block")],
                )
