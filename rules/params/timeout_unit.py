"""A timeout is given in milliseconds where seconds are read, or the reverse.

## What it finds
`cmd_vel_timeout` or `reference_timeout` of more than 10 s in the block of a controller whose type is a drive controller
of ros2_controllers, which reads seconds. Timeouts of velocities, deadman switches and joysticks whose name ends with
`_s` or `_sec` and that are 60 s or more; and timeouts of commands, watchdogs and deadman switches whose name ends with
`_ms` and that are less than one millisecond. Times after which a robot that nobody drives goes to sleep or ends a
session are left out.

Parameter files, launch files, and `-p name:=value` in units, compose files and scripts are read.

## Why it matters on a robot
The timeout stops the wheels when commands no longer arrive. With 500 s instead of 0.5 s the robot drives on with its
last speed when the Wi-Fi is gone or navigation has crashed. With 0.5 ms each command is too old before the next one
comes, and the robot does not move, or stutters.

## Bad
```yaml
controller_manager:
  ros__parameters:
    wheels: {type: diff_drive_controller/DiffDriveController}
wheels:
  ros__parameters:
    left_wheel_names: [left_wheel]
    cmd_vel_timeout: 500.0
```

## Good
```yaml
controller_manager:
  ros__parameters:
    wheels: {type: diff_drive_controller/DiffDriveController}
wheels:
  ros__parameters:
    left_wheel_names: [left_wheel]
    cmd_vel_timeout: 0.5
```

## When to ignore it
When something else stops the motors sooner.

## References
- https://control.ros.org/jazzy/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html, `cmd_vel_timeout`
- https://control.ros.org/jazzy/doc/ros2_controllers/mecanum_drive_controller/doc/userdoc.html, `reference_timeout`
"""

from collections.abc import Iterator
from collections.abc import Sequence
from itertools import pairwise

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import NamedTuple
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.params import ParameterFile

_SECONDS = regex(r"(?:\w{1,40}_)?(?:cmd_vel|deadman|teleop|joy)\w{0,40}timeout_(?:s|secs?|seconds)\Z", hints="timeout")
_MILLISECONDS = regex(
    r"(?:\w{1,40}_)?(?:(?:cmd|command|watchdog|deadman|heartbeat|teleop|joy)_(?:\w{1,40}_)?(?:timeout|max_age|deadline)"
    r"|watchdog|deadman|heartbeat)_(?:ms|msecs?|millis)\Z",
    hints="_m",
)
_UNHURRIED = regex(r"idle|shutdown|session|sleep|standby|disconnect|pair")
"""Timeouts that have nothing to do with a robot that moves."""
_CONTROLLERS = ("cmd_vel_timeout", "reference_timeout")
_DRIVES = (
    "diff_drive_controller/DiffDriveController",
    "mecanum_drive_controller/MecanumDriveController",
    "omni_wheel_drive_controller/OmniWheelDriveController",
    "tricycle_controller/TricycleController",
    "ackermann_steering_controller/AckermannSteeringController",
    "bicycle_steering_controller/BicycleSteeringController",
    "tricycle_steering_controller/TricycleSteeringController",
)
"""Types of the drive controllers of ros2_controllers."""
_ENDLESS, _LONG = 60.0, 10.0
_MOST = 1e15
"""More is no setting."""


class Setting(NamedTuple):
    name: str
    value: object
    where: Span
    file: ParameterFile | None = None
    of_drive: bool = False
    """Of a drive controller of ros2_controllers."""


@rule("error", silent="the controller keeps the last speed, or zero, without a word")
def timeout_unit(robot: Robot) -> Iterator[Finding]:
    for each in _settings(robot):
        wrong = _wrong(each)
        if wrong is not None:
            message, advice = wrong
            is_idle = each.file is not None and not robot.params.is_used(each.file)
            yield finding(each.where, message, advice=advice, severity="info" if is_idle else None)


def _settings(robot: Robot) -> Iterator[Setting]:
    """What parameter files, launch files and command lines set."""
    drives = set(_drives(robot))
    for file in robot.params.judged:
        for block in file.blocks:
            of_drive = block.node_name in drives
            for each in block.parameters:
                yield Setting(str(each.name), each.value.data, each.span, file, of_drive)
    if robot.has_launch_files:
        for node in robot.launch.nodes:
            yield from _of_node(node)
    for runner in robot.runners.ros:
        for start in runner.starts:
            yield from _of_words(start.ros.arguments)


def _drives(robot: Robot) -> Iterator[str]:
    """The names of controllers that have the type of a drive controller."""
    for file in robot.params.parameter_files:
        for each in file.parameters:
            if str(each.value.data) in _DRIVES:
                yield each.block.node_name if each.name == "type" else each.name.removesuffix(".type")


def _of_node(node: launch.Started) -> Iterator[Setting]:
    for key, value in node.given:
        inner = value.value if isinstance(value, launch.TypedValue) else value
        if isinstance(inner, launch.Literal):
            yield Setting(str(launch.literal(key)), inner.value, inner.span)


def _of_words(words: Sequence[Located]) -> Iterator[Setting]:
    for before, word in pairwise(words):
        if before in ("-p", "--param"):
            name, _, text = word.partition(":=")
            yield Setting(name.rpartition(":")[2], _number(text), word.span)


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _wrong(setting: Setting) -> tuple[str, str] | None:
    """The message and the advice for a timeout in the wrong unit."""
    value, last = setting.value, setting.name.rpartition(".")[2]
    if not isinstance(value, (int, float)) or isinstance(value, bool) or abs(value) > _MOST:
        return None
    if _UNHURRIED.search(last):
        return None
    is_long = setting.of_drive and last in _CONTROLLERS and value > _LONG
    if is_long or (_SECONDS.match(last) and value >= _ENDLESS):
        return (
            f"{last} is in seconds: after the last command the robot may keep its speed for {value:g} s",
            f"write seconds, such as {value / 1000:g}" if value >= 100 else "write a few tenths of a second",
        )
    if _MILLISECONDS.match(last) and 0 < value < 1:
        return (
            f"{last} is in milliseconds: after {value:g} ms each command is too old before the next one arrives",
            f"write milliseconds, such as {value * 1000:g}",
        )
    return None
