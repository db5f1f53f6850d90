"""A node with security switched on selects no enclave.

## What it finds
A process that has `ROS_SECURITY_ENABLE` set to true, but neither `--enclave` nor
`ROS_SECURITY_ENCLAVE_OVERRIDE`. Two kinds of processes are checked:
- nodes of launch files, secured by `additional_env`, by `SetEnvironmentVariable`, or by the environment of
  the unit, service or script that runs `ros2 launch`
- nodes that a command line starts with `ros2 run`
- nodes of launch files beside others that select an enclave, where a script exports the variable with Enforce, and the
  tree holds the keystore; an info where another launch file starts the same program with an enclave

A keystore with an enclave for `/` counts as intent, and nothing is reported. Without a keystore in the tree
the finding is a warning, because the robot may have an enclave `/`, unless the node itself sets the variable
(`additional_env`).

## Why it matters on a robot
The process uses the enclave `/`, whatever the node is called. With Enforce it ends because the directory is
incomplete. Otherwise all such processes share one identity.

## Bad
```python
Node(package="lawn", executable="driver", additional_env={"ROS_SECURITY_ENABLE": "true"})
```

## Good
```python
Node(package="lawn", executable="driver", ros_arguments=["--enclave", "/lawn/driver"],
     additional_env={"ROS_SECURITY_ENABLE": "true"})
```

## When to ignore it
If one identity for the whole robot is intended and the keystore on the robot has an enclave for `/`.

## References
- rcl, security.c; tested with the real rcl of Jazzy
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["SECURITY ERROR: directory"])
def enclave_not_selected(robot: Robot) -> Iterator[Finding]:
    if robot.sros2.overridden or any("/" in keystore.enclaves for keystore in robot.sros2.keystores):
        return
    for found in robot.sros2.without_enclave:
        left = [each for each in found if not each.elsewhere]
        group = left or found
        first = group[0]
        if not first.own and robot.ros.is_development(first.where):
            continue
        more = f" and {len(group) - 1} more select" if len(group) > 1 else " selects"
        they = "they use '/'" if len(group) > 1 else "it uses '/'"
        is_chosen = first.own or (bool(robot.sros2.keystores) and not first.by_hand)
        yield finding(
            first.where,
            f"{first.label}{more} no enclave: {they}, which fails with Enforce and is a shared identity without it",
            advice="add --ros-args --enclave /... to each process; in launch files ros_arguments=['--enclave', '/...']",
            related=[
                note(first.switch, "security is switched on here"),
                *(note(other.where, "this one selects none either") for other in group[1:6]),
            ],
            severity="info" if first.elsewhere else None if is_chosen else "warning",
        )
