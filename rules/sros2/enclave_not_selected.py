"""A secured node without an enclave.

## What it finds
A process with security switched on that selects no enclave: nodes of launch files (by `additional_env`,
`SetEnvironmentVariable`, or the environment of the unit, service or script that runs `ros2 launch`) and `ros2 run` on
command lines, without `--enclave` and without `ROS_SECURITY_ENCLAVE_OVERRIDE`. A keystore with an enclave for `/` is
taken as on purpose.

## Why it matters on a robot
The process uses the enclave `/`, whatever the node is called: with Enforce it ends because the directory is
incomplete, else all such processes share one identity. Where no keystore is in the tree, an enclave `/` may exist: then
it is a warning.

## Bad
```python
Node(package="lawn", executable="driver", additional_env={"ROS_SECURITY_ENABLE": "true"})
```

## Good
```python
Node(package="lawn", executable="driver", ros_arguments=["--enclave", "/lawn/driver"],
     additional_env={"ROS_SECURITY_ENABLE": "true"})
```

## References
- rcl, security.c; tried with the real rcl of Jazzy
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["SECURITY ERROR: directory"])
def enclave_not_selected(robot: Robot):
    if robot.sros2.overridden or any("/" in keystore.enclaves for keystore in robot.sros2.keystores):
        return
    for group in robot.sros2.without_enclave:
        first = group[0]
        if not first.own and robot.ros.is_development(first.where):
            continue
        more = f" and {len(group) - 1} more select" if len(group) > 1 else " selects"
        they = "they use '/' and not their names" if len(group) > 1 else "it uses '/' and not its name"
        yield finding(
            first.where,
            f"{first.label}{more} no enclave: {they}, with Enforce nothing of it starts, else it shares that identity",
            advice="add --ros-args --enclave /... to each process, in launch files ros_arguments=['--enclave', '/...']",
            related=[
                note(first.switch, "security is switched on here"),
                *(note(other.where, "selects none either") for other in group[1:6]),
            ],
            severity=None if first.own or robot.sros2.keystores else "warning",
        )
