"""A frame, joint or hardware name that differs in one letter from the one that the robot has.

## What it finds
Frames and joints in parameter files, links and joints that robot descriptions name, the parameters and interfaces in
their `<ros2_control>`, and the names of these in the sources of hardware: one that nothing else of the tree has, and
that has a letter more or less, or two swapped, than exactly one name that other places have.

## Why it matters on a robot
Frames and joints are looked up by their names, as texts, when the robot runs. tf2 waits for a transform that never
comes, a controller is not configured, and hardware gets an empty text for its parameter or exports an interface that
no controller asks for.

## Bad
```yaml
amcl:
  ros__parameters:
    base_frame_id: base_footprnt
```

## Good
```yaml
amcl:
  ros__parameters:
    base_frame_id: base_footprint
```

## When to ignore it
When a program outside of the tree has both names.

## References
- REP 105, Coordinate Frames for Mobile Platforms
- https://control.ros.org/rolling/doc/ros2_control/hardware_interface/doc/hardware_interface_types_userdoc.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import unknown_frames

_WHAT = {
    "frame": "No frame or joint",
    "link": "No link",
    "joint": "No joint",
    "hardware": "Nothing in a source of the hardware",
    "code": "Nothing in <ros2_control>",
}


@rule(
    "warning",
    confidence="medium",
    silent="what looks the name up waits, or says that it is not there, and names no file",
)
def robot_name_misspelt(robot: Robot) -> Iterator[Finding]:
    misspelt = robot.plugins.misspelt_names
    said = _said(robot) if misspelt else set()
    for each in misspelt:
        if said.isdisjoint((each.where, each.name, each.near)):
            yield finding(
                each.where,
                f"{_WHAT[each.kind]} is called '{each.name}', and nothing else has the name: it is never found",
                advice=f"did you mean {each.near}?",
                related=[note(each.known, "the name that is known")] if each.known is not None else [],
            )


def _said(robot: Robot) -> set[Span | str]:
    """The places and names of which other rules speak."""
    said: set[Span | str] = {each.where for each in robot.plugins.unknown_joints}
    said |= {each.name.span for each in unknown_frames(robot.topics)}
    said |= {one.where for each in robot.plugins.refused_descriptions for one in each}
    return said | {name for each in robot.plugins.hardware_parameters for name in (each.name, *each.others)}
