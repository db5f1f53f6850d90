"""A launch file uses an argument that launch_ros no longer has.

## What it finds
`node_executable=`, `node_name=`, `node_namespace=` and `node_plugin=` of `Node` and `ComposableNode`. They were removed
after Foxy. Silent when the tree is for Foxy, and when the file looks itself which distribution runs.

## Why it matters on a robot
`Node()` raises a TypeError: launch ends before it starts a single node.

## Bad
```python
Node(package='demo', node_executable='driver', node_name='front')
```

## Good
```python
Node(package='demo', executable='driver', name='front')
```

## When to ignore it
When the robot runs Foxy or older, and the tree does not say so.

## References
- launch_ros, `Node` and `ComposableNode`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import OldKeyword


@rule(
    "error",
    fix="safe",
    symptoms=[
        "got an unexpected keyword argument 'node_executable'",
        "UserWarning: The parameter 'node_executable' is deprecated, use 'executable' instead",
    ],
)
def removed_keyword(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        found = list(launch.removed_keywords(robot.launch, file))
        if not found:
            continue
        first, *others = found
        words = ", ".join(dict.fromkeys(each.now for each in found))
        is_doubled = any(each.is_doubled for each in found)
        yield finding(
            first.name,
            f"{first.owner} has had no argument '{first.name}' since Galactic: launch ends with a TypeError",
            advice=advice_on(first) if is_doubled else f"write {words}",
            related=[note(each.name, f"removed, too: {advice_on(each)}") for each in others],
            fix=None if is_doubled else fix(f"write {words}", *((each.name, each.now) for each in found)),
        )


def advice_on(keyword: OldKeyword) -> str:
    """Python refuses a keyword that is repeated."""
    return f"remove it: {keyword.now}= is there, too" if keyword.is_doubled else f"write {keyword.now}"
