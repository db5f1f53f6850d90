"""From a command line of a unit to the launch file that it starts."""

from __future__ import annotations

from bringup_lint.graph.commands.command_line import scripts_of
from bringup_lint.graph.supervision.launched_processes import respawns
from bringup_lint.pattern import regex
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.commands.ros_command import Ros
    from bringup_lint.graph.host.device_uses import DeviceUse
    from bringup_lint.graph.host.devices import Devices
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.graph.launch.launch import Launch
    from bringup_lint.graph.systemd.unit import Unit
    from bringup_lint.graph.systemd.units import Units

_CHOOSES = regex(r"\b(?:for|case|select)\b|/dev/[\w-]*[*?]")


def expansion_of(ros: Ros, launch: Launch) -> Expansion | None:
    """What ``ros2 launch PACKAGE FILE`` or ``ros2 launch PATH`` leads to; None when the file is not in the tree."""
    if ros.kind != "launch" or ros.target is None:
        return None
    file = launch.named(ros.package, ros.target)
    return None if file is None else launch.expansion(file)


def every_node_respawns(expansion: Expansion) -> bool:
    """Whether launch itself starts every process again that ends."""
    return bool(expansion.nodes) and all(respawns(node) for node in expansion.nodes)


def devices_opened_by(unit: Unit, units: Units, launch: Launch, devices: Devices) -> list[DeviceUse]:
    """Device paths in the unit, its scripts and its launch files."""
    sources = {file.source for file in unit.files}
    for process in units.processes(unit):
        sources.update(scripts_of(process.steps))
        for _, ros in process.launches:
            expansion = expansion_of(ros, launch)
            if expansion is not None:
                sources.update(file.source for file in expansion.files)
    sources.update(variable.value.span.source for variable in units.environment(unit))
    own = [use for use in devices.uses if use.path.span.source in sources]
    return [use for use in own if use.certainty in ("literal", "unit") or _is_only_one(use, own)]


def _is_only_one(use: DeviceUse, others: list[DeviceUse]) -> bool:
    """Whether a script names no other device, so that it opens this one rather than choose among several."""
    paths = {each.path for each in others if each.path.span.source is use.path.span.source}
    return use.certainty == "script" and len(paths) == 1 and not _CHOOSES.search(use.path.span.source.text)
