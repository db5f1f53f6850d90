"""A robot description has the hardware of one simulator, and loads the plugin of another.

## What it finds
Descriptions whose `<ros2_control>` has `gazebo_ros2_control/GazeboSystem` while the descriptions of the package, or
those that are included with them, load the plugin of the new Gazebo (`gz_ros2_control-system`,
`ign_ros2_control-system`), and the other way round. Silent where the description has hardware for both.

## Why it matters on a robot
The plugin of each simulator loads hardware of its own kind only: "According to the loaded plugin descriptions the class
... does not exist". The simulated robot has no hardware, and the spawners of its controllers wait in vain.

## Bad
```xml
<plugin>gazebo_ros2_control/GazeboSystem</plugin>
<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/></gazebo>
```

## Good
```xml
<plugin>gz_ros2_control/GazeboSimSystem</plugin>
<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin"/></gazebo>
```

## When to ignore it
When a simulation outside of the tree loads the other plugin.

## References
- https://control.ros.org/jazzy/doc/gz_ros2_control/doc/index.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["The plugin failed to load for some reason", "According to the loaded plugin descriptions"])
def simulator_hardware_mismatch(robot: Robot) -> Iterator[Finding]:
    for each in robot.plugins.other_simulators:
        loader = each.loader.rpartition("/")[2]
        yield finding(
            each.hardware,
            f"{loader} does not load {each.hardware}: the simulated robot has no hardware, and no controller starts",
            advice=f"write {each.instead}",
            related=[note(each.loader, "the plugin of another simulator")],
        )
