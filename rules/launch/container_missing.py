"""Components are loaded into a container that does not exist.

## What it finds
`LoadComposableNodes` whose target is not a container of the launch graph. Silent where part of the launch graph is
unknown, and where no container is started at all. An action with a condition is a warning.

## Why it matters on a robot
launch waits forever for the container's service. The components never load, and no message says why until somebody
stops the launch.

## Bad
```python
LoadComposableNodes(target_container='perception', composable_node_descriptions=[...])   # the container: 'vision'
```

## Good
```python
LoadComposableNodes(target_container='vision', composable_node_descriptions=[...])
```

## When to ignore it
When another launch file, which this one does not include, starts the container under exactly this name before the
components are loaded.

## References
- launch_ros, `LoadComposableNodes`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", symptoms=["Abandoning wait for the '*/_container/load_node' service, due to shutdown."])
def container_missing(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        if expansion.open:
            continue
        containers: dict[str | None, launch.Started] = {}
        for node in expansion.nodes:
            name = launch.literal_text(node.name)
            if isinstance(node.action, launch.Node) and (
                node.action.container or "container" in str(launch.literal_text(node.executable))
            ):
                containers[name] = node
        names = sorted(name for name in containers if name is not None)
        if not names or len(names) < len(containers):
            continue
        for load in expansion.loads:
            text = launch.literal_text(load.target)
            if text is None or load.by_default is False or text.rpartition("/")[2] in names:
                continue
            near = nearest(text.rpartition("/")[2], names, 3) or names[:1]
            yield finding(
                text,
                f"Nothing starts the container '{text}': launch waits forever and the components never load",
                advice=f"load them into '{near[0]}'",
                related=[note(containers[near[0]].span, f"container '{near[0]}'")],
                severity="warning" if load.conditions else None,
            )
