"""A lifecycle manager waits for a node that is not started.

## What it finds
Entries of `node_names` that no node of the launch graph has as its name, resolved in the manager's namespace.

## Why it matters on a robot
The manager waits for the services of a node that never starts, or aborts the bring-up. None of its nodes is
activated.

## Bad
```python
Node(package='my_camera', executable='camera', name='camera_front'),
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager',
     parameters=[{'autostart': True, 'node_names': ['camera_driver']}]),
```

## Good
```python
Node(package='my_camera', executable='camera', name='camera_front'),
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='manager',
     parameters=[{'autostart': True, 'node_names': ['camera_front']}]),
```

## When to ignore it
When something outside this tree starts the node, such as a separate service or another computer.

## References
- https://github.com/ros-navigation/navigation2/issues/1447
- https://github.com/ros-navigation/navigation2/issues/4350
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule("error", fix="unsafe", symptoms=["Waiting for service", "Failed to change state for node"])
def lifecycle_unknown_node(robot: Robot) -> Iterator[Finding]:
    for expansion in robot.launch.entries:
        managers = launch.managers(expansion)
        if not managers or launch.outside(expansion):
            continue
        started = {launch.full_name(node, robot.launch.role(node)): node for node in expansion.nodes if node.is_node}
        if len(started) == len(managers):
            yield from alone(robot, managers)
            continue
        bare = {name.rpartition("/")[2]: node for name, node in started.items() if name is not None}
        nav2 = launch.lifecycle_names() if expansion.open else ()
        for manager in managers:
            for managed in listed(robot, manager):
                last = managed.fqn.rpartition("/")[2]
                if managed.fqn in started or last in nav2:
                    continue
                unsure = None in started or expansion.open
                if unsure and (last in robot.launch.all_names or (last not in bare and not nearest(last, bare))):
                    continue
                yield from described(robot, manager, managed, bare)


def listed(robot: Robot, manager: launch.Manager) -> list[launch.Managed]:
    """The nodes that a manager brings up, by the launch file or by its parameter file."""
    if manager.names.value is None and not manager.names.known:
        return manager.called(robot.params.texts(manager.node, "node_names") or []) or []
    return manager.managed or []


def alone(robot: Robot, managers: list[launch.Manager]) -> Iterator[Finding]:
    """A manager in a separate launch file: its nodes are in other files, if at least one of them is."""
    if any(launch.outside(expansion) for expansion in robot.launch.expansions):
        return
    for manager in managers:
        names = robot.launch.names_near(manager.node.file)
        wanted = {managed.fqn.rpartition("/")[2]: managed for managed in listed(robot, manager)}
        if names.isdisjoint(wanted):
            continue
        for last, managed in wanted.items():
            if last not in names and last not in launch.lifecycle_names():
                yield from described(robot, manager, managed, {})


def described(
    robot: Robot, manager: launch.Manager, managed: launch.Managed, bare: dict[str, launch.Started]
) -> Iterator[Finding]:
    last = managed.fqn.rpartition("/")[2]
    near = [last] if last in bare else nearest(last, bare, 3)
    if last in bare:
        is_called = launch.full_name(bare[last], robot.launch.role(bare[last]))
        message = f"The manager looks for {managed.fqn}, but the node is {is_called}"
        advice = "start the manager in the namespace of its nodes"
    else:
        message = f"No node {managed.fqn} is started: the manager waits for it and brings nothing up"
        advice = f"list '{near[0]}'" if near else "remove it from node_names, or start the node"
    exact = len(near) == 1 and last not in bare and managed.name.span.text == managed.name
    yield finding(
        managed.name,
        message,
        advice=advice,
        related=[note(bare[name].span, f"node '{name}' is started here") for name in near[:3]]
        or [note(manager.node.span, "the manager")],
        chain=robot.provenance.chain_to(managed.name, f"the manager waits for {managed.fqn}"),
        fix=fix(f"list '{near[0]}'", (managed.name, near[0]), safe=False) if exact else None,
    )
