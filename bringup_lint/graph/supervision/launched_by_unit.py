"""From a command line of a unit to the launch file that it starts."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.commands.ros_command import Ros

if TYPE_CHECKING:
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.robot import Robot


def launched(ros: Ros, robot: Robot) -> Expansion | None:
    """What ``ros2 launch PACKAGE FILE`` leads to; None when the file is not in the tree."""
    if ros.kind != "launch" or ros.package is None or ros.target is None:
        return None
    launch = robot.launch
    for file in launch.files:
        owner = launch.workspace.owner(file.source)
        if owner is not None and owner.name == ros.package and file.source.basename == ros.target:
            return launch.expansion(file)
    return None


def all_respawn(expansion: Expansion) -> bool:
    """Whether launch itself starts every process again that ends."""
    from bringup_lint.graph.supervision.launched_processes import respawns

    return bool(expansion.nodes) and all(respawns(node) for node in expansion.nodes)


def devices_of(unit: Unit, robot: Robot):
    """Device paths (``graph.devices.DeviceUse``) in the unit, its scripts and its launch files."""
    sources = {id(file.source) for file in unit.files}
    for process in robot.units.processes(unit):
        sources |= {id(step.script) for step in process.steps if step.script}
        for _, ros in process.launches:
            expansion = launched(ros, robot)
            sources |= {id(file.source) for file in expansion.files} if expansion else set()
    for variable in robot.units.environment(unit):
        sources.add(id(variable.value.span.source))
    return [
        use
        for use in robot.devices.uses
        if id(use.path.span.source) in sources and use.certainty in ("literal", "unit")
    ]
