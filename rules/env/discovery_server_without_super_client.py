"""Tools see nothing through the discovery server, or nothing starts it.

## What it finds
A login file (`.bashrc`, `profile.d`, `/etc/environment`, ...) that sets `ROS_DISCOVERY_SERVER`, when no login file
of the tree sets `ROS_SUPER_CLIENT` or a Fast DDS profile. In a root file system also units whose server is on this
machine, when nothing in the tree starts one (`fastdds discovery`).

## Why it matters on a robot
An ordinary client learns only about the topics that it uses itself: `ros2 topic list` shows nothing although the
robot works. Without the server no node finds another.

## Bad
```sh
# /home/robot/.bashrc
export ROS_DISCOVERY_SERVER=10.0.0.10:11811
```

## Good
```sh
export ROS_DISCOVERY_SERVER=10.0.0.10:11811
export ROS_SUPER_CLIENT=TRUE
```

## When to ignore it
When nobody uses the ROS command line tools in these shells, or when the server is started outside the tree.

## References
- ROS 2 documentation, "Using Fast DDS Discovery Server as discovery protocol"
- https://github.com/ros2/ros2cli/issues/952
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.addresses import host_of
from bringup_lint.api.addresses import is_loopback

SERVER = "ROS_DISCOVERY_SERVER"
SEES = regex(r"^[^#\n]*\b(?:ROS_SUPER_CLIENT|FAST(?:RTPS|DDS)_DEFAULT_PROFILES_FILE)=", re.M)
SETS = regex(r"^[^#\n]*\bROS_DISCOVERY_SERVER=([^\s#]+)", re.M)
STARTS = regex(r"fastdds[\s\"',]+discovery|fast-discovery-server|discovery_server|discoveryProtocol>(?:SERVER|BACKUP)<")


@rule("warning", symptoms=["ros2 topic list shows nothing"])
def discovery_server_without_super_client(robot: Robot) -> Iterator[Finding]:
    files = robot.ros.login_files
    found = [(source, match) for source in files if source.judged for match in [SETS.search(source.said)] if match]
    if found and not any(source.says(SEES) for source in files):
        places = [source.located(match.start(1), match.end(1)) for source, match in found]
        yield finding(
            places[0],
            "The command line tools are ordinary clients of the discovery server: ros2 topic list shows nothing",
            advice="also export ROS_SUPER_CLIENT=TRUE, or, up to Humble, a Fast DDS profile with SUPER_CLIENT",
            related=[note(other, "also here") for other in places[1:4]],
        )
    if not robot.tree.complete or any(source.says(STARTS) for source in robot.sources):
        return
    for process in robot.ros.processes:
        server = process.environment.get(SERVER)
        if process.unit is None or server is None or not server.text:
            continue
        hosts = [part for part in server.text.split(";") if part.strip()]
        if hosts and all(is_loopback(host_of(host.strip())) for host in hosts):
            yield finding(
                server.value,
                f"Nothing on this robot starts the discovery server: the nodes of {process.name} find no other node",
                advice="add a unit that runs fastdds discovery, and order the others after it",
                related=[note(process.where, f"{process.name} is its client")],
            )
            return
