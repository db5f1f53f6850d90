"""A topic is remapped twice.

## What it finds
Two remappings of one node with the same source and different targets.

## Why it matters on a robot
The first rule applies and the second never does: data goes to a topic that nobody reads.

## Bad
```python
remappings=[('scan', 'scan_front'), ('scan', '/scan')]
```

## Good
```python
remappings=[('scan', 'scan_front')]
```

## When to ignore it
Never: rcl stops at the first rule that matches, so the second line has no effect.

## References
- ROS 2 design, "Topic and Service name mapping", remapping rules are applied in order
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.python import remove


@rule("warning", fix="safe", silent="one of the remappings applies without a message")
def remap_duplicate(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        first: dict[str, tuple[Located, Located | None]] = {}
        for src, dst in getattr(node.action, "remappings", ()):
            source, target = launch.literal(src), launch.literal(dst)
            if source is None:
                continue
            before = first.setdefault(source, (source, target))
            if before[0] is not source and before[1] is not None and target is not None and before[1] != target:
                is_own = node.action.span.holds(source.span)  # other nodes may use a list that is outside
                drop = remove(source.span) if is_own else None
                yield finding(
                    source,
                    f"'{source}' is remapped twice: the first rule applies and '{target}' is never used",
                    advice="keep one of them",
                    fix=fix("remove the rule that never applies", codemod=drop) if drop else None,
                    related=[note(before[0], "the first rule")],
                )
