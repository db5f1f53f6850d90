"""Which topics move the robot: velocities, efforts and brakes."""

from __future__ import annotations

import re

from bringup_lint.model.node_source import Endpoint
from bringup_lint.pattern import regex

_VELOCITIES = frozenset(
    f"{package}/msg/{name}"
    for package, names in {
        "geometry_msgs": ("Twist", "TwistStamped"),
        "ackermann_msgs": ("AckermannDrive", "AckermannDriveStamped"),
        "std_msgs": (
            "Float64",
            "Float32",
            "Float64MultiArray",
            "Float32MultiArray",
            "Int16",
            "Int32",
            "Int16MultiArray",
        ),
        "control_msgs": ("JointJog", "MultiDOFCommand"),
    }.items()
    for name in names
)
_NUMBERS = frozenset(name for name in _VELOCITIES if name.startswith("std_msgs/"))
_SPEED = regex(
    r"vel|speed|throttle|thrust|pwm|effort|torque|wheel|motor|drive|brake|winch|propel|rotor|blade|pump|conveyor", re.I
)
"""What a bare number must be called to be a velocity: a position is held, not run on with."""
_COMMAND = regex(r"(?:^|[/_])(?:cmd_?vel|cmd|commands?|vel|velocity|drive|throttle|pwm|effort|brake)s?(?=$|[/_])", re.I)
_COMMON = frozenset({"std_msgs", "sensor_msgs", "nav_msgs", "geometry_msgs", "diagnostic_msgs", "trajectory_msgs"})
"""Packages whose types say nothing of motors by their names."""
_REPORT = regex(
    r"(?:^|[/_])(?:odom\w*|state|status|feedback|measured|actual|current|estimate\w*|viz|debug|imu|encoder\w*)(?=$|[/_])",
    re.I,
)

_AIMED = regex(r"gimbal|pan_?tilt|turret|camera|(?:^|[/_])ptz(?=$|[/_])", re.I)
"""What turns a camera or the like ends at its stop, and moves no robot."""


def is_aimed(endpoint: Endpoint) -> bool:
    """Whether a topic turns a camera or the like, by its name."""
    return _AIMED.search(str(endpoint.name or "")) is not None


def is_velocity(endpoint: Endpoint) -> bool:
    """Whether the messages are velocities by their type, however the topic is called."""
    return endpoint.type in _VELOCITIES - _NUMBERS and not is_aimed(endpoint)


def moves(endpoint: Endpoint) -> bool:
    """Whether what is published here makes something move until it is told to stop."""
    if endpoint.name is None or endpoint.type not in (None, *_VELOCITIES) or is_aimed(endpoint):
        return False
    if endpoint.type is None:
        return endpoint.name.rpartition("/")[2] == "cmd_vel"
    if endpoint.type in _NUMBERS and (not _SPEED.search(endpoint.name) or "position" in endpoint.name):
        return False
    return bool(_COMMAND.search(endpoint.name)) and not _REPORT.search(endpoint.name)


_OF_MOTORS = regex(r"Motor|Wheel|Thrust|Throttle|Drive|Vel(?:ocity|ocities|s)?(?=[A-Z]|$)|Speed|Twist|Pwm|PWM|RPM|Rpm")
_OTHER = regex(
    r"State|Status|Feedback|Info|Odom|Angle|Position|Servo|Report|Current|Temp|Encoder|Telemetry|Driver(?=[A-Z])"
)


def is_motor_command(endpoint: Endpoint) -> bool:
    """Whether the messages that come in are commands for motors, by the name of a message type of the robot's own."""
    return endpoint.role == "subscription" and is_for_motors(endpoint)


def is_for_motors(endpoint: Endpoint) -> bool:
    """Whether the messages are commands for motors, by the name of a message type of the robot's own."""
    package, _, kind = (endpoint.type or "").partition("/msg/")
    if not kind or package in _COMMON or endpoint.type in _VELOCITIES:
        return False
    if _OTHER.search(kind) or is_aimed(endpoint) or _REPORT.search(str(endpoint.name or "")):
        return False
    return bool(_OF_MOTORS.search(kind))


_REMOTE = regex(
    r"(?:^unitree_(?:go|api|hg)/msg/(?:WirelessController|Request|LowCmd)|/(?:ServoCtrlMsg|OverrideRCIn"
    r"|ManualControl(?:Setpoint|Input)?|VehicleCommand|SpeedCommand|MotorCommand|\w{0,30}MotorCmd|DriveCmd))\Z"
)
_SETPOINTS = regex(r"/(?:JointTrajectory|PositionTarget|AttitudeTarget|TrajectorySetpoint)\Z")
_GOALS = regex(r"/(?:Navigate(?:ToPose|ThroughPoses)|FollowWaypoints|FollowJointTrajectory|MoveGroup|DriveOnHeading)\Z")
_COMMAND_TOPIC = regex(r"[\"'/}](?:cmd|commands?|cmd_vel|goal_pose)[\"'/]|[\"'/}](?:take_?off|disarm|arming|kill)[\"']")
_ORDERS = regex(r"^mavros_msgs/srv/(?:Command\w{1,20}|SetMode)\Z")
"""What an autopilot is asked to do: to arm, to take off, to change its mode."""

_TWIST = regex(r"\bTwist(?:Stamped)?\b")


def is_remote(endpoint: Endpoint) -> bool:
    """Whether the messages are those of a remote control, an autopilot or a motor board, by their type."""
    return _REMOTE.search(endpoint.type or "") is not None and not is_aimed(endpoint)


def is_commanding(endpoint: Endpoint) -> bool:
    """Whether a node tells the robot by it what to do: by velocities, by the messages of a remote control or an
    autopilot, by goals, or on a topic for commands."""
    if endpoint.role == "action-client":
        return _GOALS.search(endpoint.type or "") is not None
    if endpoint.role == "client":
        return _ORDERS.search(endpoint.type or "") is not None
    if endpoint.role != "publisher" or is_aimed(endpoint):
        return False
    if moves(endpoint) or is_remote(endpoint) or _SETPOINTS.search(endpoint.type or ""):
        return True
    written = "" if endpoint.implied else endpoint.span.text
    return bool(_COMMAND_TOPIC.search(written)) or (endpoint.name is None and bool(_TWIST.search(written)))
