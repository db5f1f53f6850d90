"""ROS processes of different users communicate over shared memory.

## What it finds
Services of ROS 2 that start together at boot, use Fast DDS and run as different users, while nothing switches
shared memory off: their environments are known and set neither a profiles file nor
`FASTDDS_BUILTIN_TRANSPORTS`, and none has a private IPC namespace.

## Why it matters on a robot
A shared-memory segment belongs to the user who created it. Discovery uses UDP, so all topics are listed, but
no data arrives. A tool that root starts can even break running nodes.

## Bad
```xml
# driver.service has no User=: root
[Service]
User=robot
```

## Good
```xml
[Service]
User=robot            # in all of them
```

## When to ignore it
If the two services do not exchange topics with each other.

## References
- https://github.com/eProsima/Fast-DDS/issues/5258
- https://github.com/eProsima/Fast-DDS/issues/3515
- https://github.com/eProsima/Fast-DDS/issues/3475
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.dds import user_of
from bringup_lint.api.systemd import Unit


@rule(
    "error",
    confidence="medium",
    symptoms=[
        "Failed init_port fastrtps_port",
        "open_and_lock_file failed",
        "RTPS_TRANSPORT_SHM * Permission denied",
        "Failed to create segment",
        "/dev/shm/fastrtps*Permission denied",
    ],
)
def shm_across_users(robot: Robot) -> Iterator[Finding]:
    for units in robot.units.running_together:
        domains: dict[str | None, dict[str, tuple[Unit, Located | Span]]] = {}
        for process in robot.dds.sharing_memory:
            if process.unit in units:
                user, where = user_of(process.unit)
                users = domains.setdefault(process.environment.text("ROS_DOMAIN_ID"), {})
                users.setdefault(user, (process.unit, where))
        for users in domains.values():
            (first, (one, place)), *others = users.items()
            for user, (unit, where) in others:
                yield finding(
                    where,
                    f"{unit.name} runs as {user}, {one.name} as {first}: their topics are listed, but data never "
                    "arrives",
                    advice="run both as one user, or give both a UDP-only profile",
                    related=[note(place, f"{one.name} runs as {first}")],
                )
