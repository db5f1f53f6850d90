"""The simulation argument does not switch off the hardware.

## What it finds
Launch files that declare `use_sim`, `simulation` or a similar argument and start a hardware driver that neither has
a condition nor reads the argument. Input devices, such as a joystick, are left out.

## Why it matters on a robot
`use_sim:=true` on the robot still starts the real driver: the hardware moves although only a
simulation was asked for.

## Bad
```python
DeclareLaunchArgument('use_sim', default_value='false'),
Node(package='sllidar_ros2', executable='sllidar_node'),
```

## Good
```python
DeclareLaunchArgument('use_sim', default_value='false'),
Node(package='sllidar_ros2', executable='sllidar_node', condition=UnlessCondition(LaunchConfiguration('use_sim'))),
```

## When to ignore it
When the sensor is real even in the simulation, as in a hardware-in-the-loop test.

## References
- launch, conditions
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

NAMES = (
    "use_sim",
    "sim",
    "simulation",
    "use_simulation",
    "is_sim",
    "is_simulation",
    "sim_mode",
    "use_mock",
    "use_fake",
)


BY_HAND = ("joy", "joy_linux", "joy_teleop", "spacenav", "wiimote")
"""Input devices: a person drives the simulated robot with them, too."""


@rule("warning", silent="the driver starts as it would without the argument")
def sim_arg_ignored(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        expansion = robot.launch.expansion(file)
        switches = [each for each in expansion.declared if each.file is file and each.name in NAMES]
        if not switches or robot.launch.simulated(file):
            continue
        switch = switches[0]
        for node in expansion.nodes:
            if node.file is not file or node.action.conditions or node.conditions:
                continue
            if robot.launch.role(node).role != "driver" or launch.literal_text(node.package) in BY_HAND:
                continue
            values = [*getattr(node.action, "parameters", ()), *getattr(node.action, "arguments", ())]
            read = {
                str(each.name) for value in values for each in launch.walk(value) if isinstance(each, launch.Argument)
            }
            if switch.name not in read:
                yield finding(
                    node.span,
                    f"{switch.name}:=true still starts the real {node.label()}",
                    advice=f"give it condition=UnlessCondition(LaunchConfiguration('{switch.name}'))",
                    related=[note(switch.action.span, "the argument is declared here")],
                )
