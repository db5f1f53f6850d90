"""What the robot's ROS 2 does on the network: domain, middleware, security, nodes, parameters."""

from __future__ import annotations

import os

from bringup_lint.discover.tree import is_below
from bringup_lint.fleet.reduce.statements import Statements
from bringup_lint.graph.purpose import Purpose
from bringup_lint.pattern import regex
from bringup_lint.source import Source

_VARIABLES = {
    "RMW_IMPLEMENTATION": "middleware",
    "ROS_SECURITY_ENABLE": "security",
    "ROS_SECURITY_STRATEGY": "security",
    "ROS_AUTOMATIC_DISCOVERY_RANGE": "discovery",
    "ROS_LOCALHOST_ONLY": "discovery",
    "ROS_DISCOVERY_SERVER": "dds-setting",
}
_LONGEST = 120
"""Characters of a parameter that is compared: longer ones are descriptions and scripts."""
_CALIBRATION = regex(r"(?:^|[/._-])(?:calib|calibration|calibrations|intrinsics?|extrinsics?|camera_info)(?:[/._-]|$)")
_OF_ONE_MACHINE = regex(
    r"(?:^|[._])(?:calib\w*|bias(?:es)?|offsets?|trim|serial(?:_?n(?:o|umber))?|intrinsics?|extrinsics?|focal_length"
    r"|distortion\w*|multiplier)(?:$|[._])"
)
"""Parameters that are measured on each robot: that many have the nominal value says nothing of the others."""


def domain(said: Statements) -> None:
    found = said.robot.dds_domain
    if found is not None:
        said.state("domain", "", found[0], found[1])


def variables(said: Statements) -> None:
    """The variables on which robots of one role, or that talk to each other, agree, where they run on the robot."""
    for setting in said.robot.ros.of(*_VARIABLES):
        if said.robot.purpose(setting.value) is Purpose.ROBOT:
            said.state(_VARIABLES[setting.name], setting.name, setting.text, setting.value)


def nodes(said: Statements) -> None:
    """The nodes that run whenever the robot has come up."""
    for node in said.robot.expected.nodes:
        if node.must:
            said.state("node", "", node.name, node.where)


def _inside(said: Statements, source: Source) -> str:
    """The path of a file in the folder or archive of its robot: those above it are named by whoever keeps it."""
    path = source.absolute
    top = next((top for top in said.robot.tree.asked if is_below(path, (top,))), os.path.dirname(path))
    return path[len(top.rstrip("/")) :]


def parameters(said: Statements) -> None:
    for file in said.robot.params.parameter_files:
        if not file.is_certain or file.source.template or _CALIBRATION.search(_inside(said, file.source)):
            continue
        for parameter in file.parameters:
            if _OF_ONE_MACHINE.search(str(parameter.name)):
                continue
            if len(parameter.text) <= _LONGEST and said.robot.purpose(parameter.span) is Purpose.ROBOT:
                key = f"{file.source.basename} {parameter.block.name} {parameter.name}"
                said.state("parameter", key, parameter.text, parameter.span)
