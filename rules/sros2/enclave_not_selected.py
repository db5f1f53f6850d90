"""A secured node without an enclave.

## What it finds
A node whose launch file switches security on for it, without `--enclave` among its arguments and without
`ROS_SECURITY_ENCLAVE_OVERRIDE`. A keystore with an enclave for `/` is taken as on purpose.

## Why it matters on a robot
The process uses the enclave `/`, whatever the node is called: with Enforce it ends because the directory is
incomplete, else all such nodes share one identity.

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
    for node in robot.sros2.nodes:
        switch = robot.sros2.secured_by(node)
        chosen, _ = robot.sros2.enclave_of(node)
        if switch is None or chosen or not node.is_node or not node.span.source.judged:
            continue
        yield finding(
            node.span,
            f"{node.label()} selects no enclave: it uses '/' and not its name, with Enforce it ends, else it shares "
            "that identity",
            advice="add ros_arguments=['--enclave', '/...'] with the enclave of this process",
            chain=robot.ways.to_node(node),
            related=[note(switch.span, "security is switched on here")],
        )
