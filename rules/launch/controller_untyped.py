"""A controller is spawned whose type the controller manager is not given.

## What it finds
`spawner` of controller_manager with the name of a controller, when none of the parameter files and dictionaries of the
only `ros2_control_node` of the launch holds `<name>.type`, and the spawner brings no parameters itself, or only files
that are known and do not hold it either. Also a `ros2_control_node` without any parameter file, whose controllers all
lack their types; where the launch spawns none, it is a warning. For a manager inside of a simulator, which no launch
file starts: a name that nothing else of the tree holds, beside one that a parameter file holds. Managers whose
parameters are not all known are left out.

## Why it matters on a robot
The spawner ends with "The 'type' param was not defined". The hardware is up, no controller moves it, and commands to
the topics of the controller go nowhere.

## Bad
```python
Node(package='controller_manager', executable='ros2_control_node'),
Node(package='controller_manager', executable='spawner', arguments=['base_controller'])
```

## Good
```python
Node(package='controller_manager', executable='ros2_control_node', parameters=[controllers]),
Node(package='controller_manager', executable='spawner', arguments=['base_controller'])
```

## When to ignore it
When another node sets the parameters of the controller manager.

## References
- https://control.ros.org/, controller_manager, "Parameters" (`<controller_name>.type`) and "spawner"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import UntypedController
from bringup_lint.api.launch import literal_text

_SPAWNER = "spawner"


@rule("error", confidence="medium", symptoms=["The 'type' param was not defined for"])
def controller_untyped(robot: Robot) -> Iterator[Finding]:
    without: dict[object, list[UntypedController]] = {}
    for each in robot.plugins.untyped_controllers:
        if each.files:
            yield finding(
                each.name,
                f"No parameters of the controller manager say which type '{each.name}' has: its spawner fails",
                advice=f"add {each.name}.type to the file, or spawn the controller that it declares",
                related=[note(each.manager.span, "the controller manager gets its parameters here")],
                chain=robot.provenance.chain_to_node(each.spawner),
            )
        else:
            without.setdefault(each.manager.span, []).append(each)
    for each, *others in without.values():
        names = ", ".join(f"'{one.name}'" for one in (each, *others[:2]))
        yield finding(
            each.manager.span,
            f"ros2_control_node is given no parameter file: it does not know the type of any controller, and {names} "
            f"{'is' if not others else 'are'} not loaded",
            advice="pass the file with the controllers in parameters=",
            related=[note(one.name, "spawned here") for one in (each, *others[:5])],
            chain=robot.provenance.chain_to_node(each.manager),
        )
    yield from _without_spawners(robot)
    for name, spawner, other in robot.plugins.unnamed_controllers:
        yield finding(
            name,
            f"Only this launch file names '{name}': no parameter file says which type it has, and its spawner fails",
            advice="declare it with its type in the parameters of the manager, or spawn one that they declare",
            related=[note(other, "a controller that a parameter file declares")],
            severity="warning",
            chain=robot.provenance.chain_to_node(spawner),
        )


def _without_spawners(robot: Robot) -> Iterator[Finding]:
    """Controller managers without any parameter, in launches that spawn nothing."""
    spawning: set[int] | None = None
    for node in robot.launch.nodes:
        if literal_text(node.executable) != "ros2_control_node" or not node.file.source.judged:
            continue
        if node.parameters or node.arguments or getattr(node.action, "open", False):
            continue
        if spawning is None:
            spawning = _spawning(robot)
        if spawning.isdisjoint(map(id, robot.launch.leading_to(node.file))):
            yield finding(
                node.span,
                "ros2_control_node is given no parameter file: it knows no controller, and none can be loaded",
                advice="pass the file with the controllers in parameters=",
                severity="info" if _SPAWNER in node.file.source.text else "warning",
                chain=robot.provenance.chain_to_node(node),
            )


def _spawning(robot: Robot) -> set[int]:
    """``id`` of each expansion that starts a spawner."""
    return {
        id(expansion)
        for expansion in robot.launch.expansions
        if any(_SPAWNER in str(literal_text(each.executable)) for each in expansion.nodes)
    }
