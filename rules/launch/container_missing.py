"""Components are loaded into a container that nobody starts.

## What it finds
`LoadComposableNodes` whose target is no container of the launch graph.

## Why it matters on a robot
launch waits for the container's service without end: the components never load and nothing says why.

## Bad
```python
LoadComposableNodes(target_container='perception', composable_node_descriptions=[...])   # the container: 'vision'
```

## Good
```python
LoadComposableNodes(target_container='vision', composable_node_descriptions=[...])
```

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


@rule("error")
def container_missing(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        if expansion.open:
            continue
        containers = {}
        for node in expansion.nodes:
            name = launch.literal_text(node.name)
            if isinstance(node.action, launch.Node) and (
                node.action.container or "container" in str(launch.literal_text(node.executable))
            ):
                containers[name] = node
        if not containers or None in containers:
            continue
        for action, file in expansion.actions:
            target = (
                robot.launch.resolved(getattr(action, "target", None), file)
                if isinstance(action, launch.LoadComponents)
                else None
            )
            text = launch.literal_text(target)
            if text is None or text.rpartition("/")[2] in containers:
                continue
            near = nearest(text.rpartition("/")[2], containers, 3) or sorted(containers)[:1]
            yield finding(
                text,
                f"Container '{text}' is started nowhere: launch waits for ever and the components never load",
                advice=f"load them into '{near[0]}'",
                related=[note(containers[near[0]].span, f"container '{near[0]}'")],
                severity="warning" if action.conditions else None,
            )
