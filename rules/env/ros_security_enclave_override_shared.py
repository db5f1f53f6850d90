"""Several processes share one enclave.

## What it finds
`ROS_SECURITY_ENCLAVE_OVERRIDE` in a file that several units or services read.

## Why it matters on a robot
All of them get the same identity: a compromised camera driver has the permissions of the motor controller.

## Bad
```ini
# /etc/default/lawn, read by driver.service and camera.service
ROS_SECURITY_ENCLAVE_OVERRIDE=/lawn/driver
```

## Good
```ini
ExecStart=ros2 run lawn driver --ros-args --enclave /lawn/driver
```

## When to ignore it
When the processes need the same permissions and you accept one identity for all of them.

## References
- rcl, security.c; tried with the real rcl of Jazzy
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.environment import RosProcess
from bringup_lint.api.systemd import Variable


@rule("warning", silent="a shared identity works", tags=["CWE-250"])
def ros_security_enclave_override_shared(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("ROS_SECURITY_ENCLAVE_OVERRIDE"):
        return
    readers: dict[tuple[int, int], tuple[Variable, dict[str, RosProcess]]] = {}
    for process in robot.ros.processes:
        variable = process.environment.get("ROS_SECURITY_ENCLAVE_OVERRIDE")
        if variable is not None and variable.value.span.source.judged:
            key = (id(variable.value.span.source), variable.value.span.start)
            readers.setdefault(key, (variable, {}))[1][process.name] = process
    for variable, processes in readers.values():
        if len(processes) > 1:
            yield finding(
                variable.value,
                f"{' and '.join(list(processes)[:3])} share the identity {variable.value}: each has the permissions "
                "of all",
                advice="select the enclave per process with --ros-args --enclave",
                related=[note(process.where, "uses this identity") for process in list(processes.values())[:3]],
            )
