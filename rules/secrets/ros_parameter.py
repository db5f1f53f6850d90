"""A node gets a secret as a parameter.

## What it finds
Parameters with the name of a secret (`..._password`, `api_key`, `token`) that are filled from the environment or
from a launch argument, in parameter files and launch files. A parameter that holds the path of a credential file is
not reported. `secrets/plain-secret` reports values in clear text.

## Why it matters on a robot
Parameters are public on the graph: every participant can read the value with `ros2 param get`, and it appears on
/parameter_events.

## Bad
```yaml
bridge:
  ros__parameters:
    mqtt_password: $(env MQTT_PASSWORD)
```

## Good
```yaml
bridge:
  ros__parameters:
    mqtt_password_file: /run/credentials/bridge.service/mqtt
```

## When to ignore it
When SROS2 in Enforce mode denies all other participants access to the parameter services and to /parameter_events.

## References
- https://github.com/ros2/rcl/issues/527
- systemd.exec(5), "LoadCredential="
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("warning", tags=["CWE-200"])
def ros_parameter(robot: Robot) -> Iterator[Finding]:
    for found in robot.exposed_secrets:
        yield finding(
            found.where,
            f"The parameter {found.name} is public on the graph: every participant can read the secret with ros2 "
            "param get",
            chain=robot.provenance.chain_to(found.where, f"{found.name} gets the secret"),
            advice="give the node the path of a credential file that only it can read",
        )
