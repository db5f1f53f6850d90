"""A node gets a secret as a parameter.

## What it finds
Parameters with the name of a secret (`..._password`, `api_key`, `token`) that are filled from the environment or
from a launch argument, in parameter files and launch files. A parameter that holds the path of a credential file is
not reported, and neither is one of a node of the tree that no source of the tree may declare.
`secrets/plain-secret` reports values in clear text.

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
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="parameters are meant to be read by every node", tags=["CWE-200"])
def ros_parameter(robot: Robot) -> Iterator[Finding]:
    places: dict[str, list[Span]] = {}
    for each in robot.exposed_secrets:
        places.setdefault(each.name, []).append(each.where)
    for name, (first, *others) in places.items():
        yield finding(
            first,
            f"The parameter {name} is public on the graph: every participant can read the secret with ros2 param get",
            chain=robot.provenance.chain_to(first, f"{name} gets the secret"),
            advice="give the node the path of a credential file that only it can read",
            related=[note(each, "and here") for each in others],
        )
