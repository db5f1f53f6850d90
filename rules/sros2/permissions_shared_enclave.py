"""A process shares its identity with another one.

## What it finds
One enclave that two processes of the same launch file, or of the units of the same robot, select: one with
actuators (a motor, base, arm or gripper driver, or a ros2_control node), and another one without. Also a
process that selects the enclave that is called like another process beside it.

## Why it matters on a robot
Permissions belong to the enclave: the other process may do whatever the driver may. Whoever takes over the
camera node can move the wheels.

## Bad
```python
Node(package="lawn_base", executable="motor_driver", ros_arguments=["--enclave", "/lawn"]),
Node(package="lawn_camera", executable="camera", ros_arguments=["--enclave", "/lawn"]),
```

## Good
```python
Node(package="lawn_base", executable="motor_driver", ros_arguments=["--enclave", "/lawn/motor_driver"]),
Node(package="lawn_camera", executable="camera", ros_arguments=["--enclave", "/lawn/camera"]),
```

## When to ignore it
If both processes need the same rights and come from the same vendor, such as a driver and its calibration
node.

## References
- ROS 2 design, "ROS 2 Security Enclaves": one identity for a process, least privilege
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="a shared identity works", tags=["CWE-250"])
def permissions_shared_enclave(robot: Robot) -> Iterator[Finding]:
    for driver, others in robot.sros2.shared_enclaves:
        names = ", ".join(user.label for user in others[:3])
        yield finding(
            others[0].enclave,
            f"{names} and {driver.label} share the identity {driver.enclave}: whoever takes over one "
            + ("moves the robot" if driver.moves else "may do what the other may"),
            advice=f"give {driver.label} its own enclave",
            related=[
                note(driver.enclave, f"{driver.label} selects it here"),
                *(note(user.enclave, f"{user.label} selects it too") for user in others[1:6]),
            ],
        )
