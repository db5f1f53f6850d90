"""A lifecycle node is started but never configured.

## What it finds
`LifecycleNode`s, and nodes that are known to have a lifecycle (the servers of nav2, slam_toolbox from Jazzy on). A
`Node` is a warning where another launch file starts the same program as a `LifecycleNode`, where its source in the tree
is a lifecycle node and no program of the tree changes the states of nodes, and where nothing includes
the file, which lies among files that are only there to be included. They are in no lifecycle
manager's `node_names`, get no `ChangeState` event and do not configure themselves, and no script or node of the tree
that names them changes states. Info where a comment has the name in such a list: somebody took it out.

## Why it matters on a robot
The process runs and looks healthy in every process list. The node stays unconfigured and publishes nothing.

## Bad
```python
Node(package='nav2_planner', executable='planner_server', name='planner_server')
```

## Good
```python
Node(package='nav2_planner', executable='planner_server', name='planner_server'),
Node(package='nav2_lifecycle_manager', executable='lifecycle_manager', name='lifecycle_manager_navigation',
     parameters=[{'autostart': True, 'node_names': ['planner_server']}])
```

## When to ignore it
When something outside this tree drives the transitions, such as a supervisor of your own or an operator's tool.

## References
- ROS 2 design, "Managed nodes"
- nav2, lifecycle manager
"""

from collections.abc import Iterator
from functools import partial

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.topics import own_lifecycle

DRIVERS = ("driver", "hardware")
"""Roles of programs that robots have from different packages, with or without a lifecycle."""
COMMENT = regex(r"(?m)^[ \t]*(#[^\n]*)")
LISTED = regex(r"[#\[,][ \t]*[\"']([^\"'\n]+)[\"'](?=[ \t]*[\],])")


@rule("error", symptoms=["Trying to publish message on the topic *, but the publisher is not activated"])
def lifecycle_node_unmanaged(robot: Robot) -> Iterator[Finding]:
    elsewhere = launch.managed_names(robot.launch)
    if elsewhere is None:
        return
    for expansion in robot.launch.entries:
        if launch.outside(expansion) or robot.launch.simulated(expansion.entry):
            continue
        managers = launch.managers(expansion)
        for node in expansion.nodes:
            role = robot.launch.role(node)
            lifecycle = getattr(node.action, "lifecycle", False)
            name = launch.full_name(node, role)
            is_known = lifecycle or role.managed
            other = None if is_known else launch.as_lifecycle_node(robot.launch, node)
            own = None if is_known or other else own_lifecycle(robot.topics, node)
            name = name or own
            if not (is_known or other or own) or name is None or node.by_default is False:
                continue
            if role.managed is False or launch.is_plain(robot.launch, node):
                continue
            if name.rpartition("/")[2] in elsewhere or launch.transitions_elsewhere(expansion, node):
                continue
            if launch.switched_by_program(robot.launch, name.rpartition("/")[2]):
                continue
            yield finding(
                node.span,
                f"{name} is never configured: the node runs but does nothing",
                advice="add it to the node_names of a lifecycle manager, or emit ChangeState events for it",
                chain=robot.provenance.chain_to_node(node),
                related=[
                    *([note(other, "the same program is a lifecycle node here")] if other else ()),
                    *([note(own, "the source makes a lifecycle node")] if own else ()),
                    *(
                        note(each.names.name or each.node.span, "this manager does not list it")
                        for each in managers[:3]
                    ),
                ],
                severity="warning" if other or own else _severity(robot, expansion, node, bool(lifecycle), name),
                confidence="medium" if other or own else None,
            )


def _taken_out(source: Source) -> set[str]:
    """The names that comments have in lists."""
    return {name for line in COMMENT.findall(source.text) for name in LISTED.findall(line)}


def _severity(
    robot: Robot, expansion: launch.Expansion, node: launch.Started, is_lifecycle: bool, name: str
) -> str | None:
    """Lower for a driver whose package nothing of the tree needs, so that another one may be installed, and for a node
    that a comment has in the list of a manager: somebody took it out."""
    source = node.span.source
    if name.rpartition("/")[2] in source.once(LISTED, partial(_taken_out, source)):
        return "info"
    package = str(launch.literal_text(node.package))
    if not is_lifecycle and robot.launch.role(node).role in DRIVERS:
        is_needed = any(package in each.text for each in robot.of_kind("ros-package"))
        if not is_needed and not robot.dependencies.is_fetched(package):
            return "info"
    return "warning" if robot.launch.is_left_over(expansion.entry) else None
