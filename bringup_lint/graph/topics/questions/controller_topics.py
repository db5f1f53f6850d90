"""What nodes send to controllers of ros2_control under names on which these do not listen."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located

if TYPE_CHECKING:
    from bringup_lint.graph.topics.topics import Topics
    from bringup_lint.model.params import Parameter

_Takes = dict[str, tuple[str, ...]]
_COMMANDS: _Takes = {"publisher": ("commands",)}
_REFERENCE: _Takes = {"publisher": ("reference", "reference_unstamped")}
_GRIPPER: _Takes = {"action-client": ("gripper_cmd",)}
_TAKES: dict[str, _Takes] = {
    "forward_command_controller/ForwardCommandController": _COMMANDS,
    "forward_command_controller/MultiInterfaceForwardCommandController": _COMMANDS,
    "position_controllers/JointGroupPositionController": _COMMANDS,
    "velocity_controllers/JointGroupVelocityController": _COMMANDS,
    "effort_controllers/JointGroupEffortController": _COMMANDS,
    "diff_drive_controller/DiffDriveController": {"publisher": ("cmd_vel", "cmd_vel_unstamped")},
    "tricycle_controller/TricycleController": {"publisher": ("cmd_vel",)},
    "mecanum_drive_controller/MecanumDriveController": _REFERENCE,
    "ackermann_steering_controller/AckermannSteeringController": _REFERENCE,
    "bicycle_steering_controller/BicycleSteeringController": _REFERENCE,
    "joint_trajectory_controller/JointTrajectoryController": {
        "publisher": ("joint_trajectory", "speed_scaling_input"),
        "action-client": ("follow_joint_trajectory",),
    },
    "position_controllers/GripperActionController": _GRIPPER,
    "effort_controllers/GripperActionController": _GRIPPER,
}
"""Class -> role of who sends -> the last parts of the names that it takes. Source: ros2_controllers, Humble on."""


class UnheardByController(NamedTuple):
    name: Located
    controller: str
    of_class: str
    takes: tuple[str, ...]
    """The last parts of the names on which it listens."""
    typed: Parameter
    """Where the controller gets its class."""


def unheard_by_controllers(topics: Topics) -> Iterator[UnheardByController]:
    """Names that only one source has, below the name of a controller whose class is known."""
    typed = _typed(topics)
    if not typed:
        return
    for each in topics.endpoints:
        if each.name is None or each.parameter is not None or not each.span.source.judged or "$" in each.name:
            continue
        *_, controller, topic = ["", "", *each.name.strip("/").split("/")]
        parameters = typed.get(controller, [])
        classes = {str(parameter.value.data) for parameter in parameters}
        if len(classes) != 1:
            continue
        of_class = classes.pop()
        takes = _TAKES.get(of_class, {}).get(each.role, ())
        if not takes or topic in takes or of_class.partition("/")[0] in topics.launch.workspace.packages:
            continue
        path = f"{controller}/{topic}"
        if not any(path in source.text for source in topics.files.sources if source is not each.span.source):
            yield UnheardByController(each.name, controller, of_class, takes, parameters[0])


def _typed(topics: Topics) -> dict[str, list[Parameter]]:
    """The name of a controller -> where it gets its class."""
    found: dict[str, list[Parameter]] = {}
    for _, each in topics.params().parameters:
        if "/" in str(each.value.data):
            if each.name.endswith(".type"):
                found.setdefault(each.name.removesuffix(".type"), []).append(each)
            elif each.name == "type":
                found.setdefault(each.block.node_name, []).append(each)
    return found
