"""A process that moves the robot shares its identity with another one.

## What it finds
One enclave that a process with actuators (a motor, base, arm or gripper driver, a ros2_control node) and another
process of the same launch file, or of the units of the same robot, both select.

## Why it matters on a robot
Permissions belong to the enclave: the other process may do whatever the driver may, and whoever takes over the camera
node moves the wheels.

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

## References
- ROS 2 design, "ROS 2 Security Enclaves": one identity for a process, least privilege
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", tags=["CWE-250"])
def permissions_shared_enclave(robot: Robot):
    for driver, others in robot.sros2.shared_enclaves:
        names = ", ".join(user.label for user in others[:3])
        yield finding(
            others[0].enclave,
            f"{names} and {driver.label} share the identity {driver.enclave}: whoever takes over one moves the robot",
            advice=f"give {driver.label} an enclave of its own",
            related=[
                note(driver.enclave, f"{driver.label} selects it here"),
                *(note(user.enclave, f"{user.label} selects it too") for user in others[1:6]),
            ],
        )
