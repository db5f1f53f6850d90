"""A published port leads to no program of the container.

## What it finds
`ports:` of a service that starts rosbridge, foxglove_bridge, web_video_server or the agent of micro-ROS, where no
entry leads to the port on which it listens, with its protocol: that of its `port:=` or `--port`, else its default
(9090, 8765, 8080).

Silent where the service starts other programs as well, or a parameter file or variable may set the port.

## Why it matters on a robot
The container runs and its log shows no error, and nobody outside of it reaches the server: the operator's page stays
empty, or the micro-controller finds no agent.

## Bad
```yaml
bridge:
  image: tug/bridge:1.2
  command: ros2 launch rosbridge_server rosbridge_websocket_launch.xml port:=9091
  ports: ["9090:9090"]
```

## Good
```yaml
bridge:
  image: tug/bridge:1.2
  command: ros2 launch rosbridge_server rosbridge_websocket_launch.xml port:=9091
  ports: ["9090:9091"]
```

## When to ignore it
When the image changes the port by a configuration of its own.

## References
- https://docs.docker.com/reference/compose-file/services/#ports: without a protocol, it is TCP
- https://github.com/RobotWebTools/rosbridge_suite, rosbridge_websocket_launch.xml
- https://github.com/foxglove/ros-foxglove-bridge
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.compose import unserved_ports


@rule("error", confidence="medium", silent="the container runs, and connections to it are refused")
def port_mismatch(robot: Robot) -> Iterator[Finding]:
    for unserved in unserved_ports(robot.runners.all):
        entry, listener = unserved.entry, unserved.listener
        wanted = f"{listener.port}/udp" if listener.protocol == "udp" else str(listener.port)
        yield finding(
            entry.where,
            f"Nothing listens on {entry.inside.start}/{entry.protocol} in {unserved.runner.name}: "
            f"{listener.name} is on {listener.port}/{listener.protocol}, and nobody outside reaches it",
            advice=f"publish {wanted}, or let it listen on {entry.inside.start}"
            if listener.protocol == entry.protocol
            else f"publish {wanted}",
            related=[note(listener.where, "listens here")],
        )
