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
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", fix="safe", symptoms=["got an unexpected keyword argument 'node_executable'"])
def removed_keyword(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        found = list(robot.launch.removed_keywords(file))
        if not found:
            continue
        owner, keyword = found[0]
        words = list(dict.fromkeys(new_name(each) for _, each in found))
        yield finding(
            keyword,
            f"{owner} has had no argument '{keyword}' since Galactic: launch ends with a TypeError",
            advice=f"write {', '.join(words)}",
            related=[note(each, f"removed, too: write {new_name(each)}") for _, each in found[1:]],
            fix=fix(f"write {', '.join(words)}", *((each, new_name(each)) for _, each in found)),
        )


def new_name(keyword: str) -> str:
    return keyword.removeprefix("node_")
