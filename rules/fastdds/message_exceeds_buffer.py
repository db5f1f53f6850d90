"""A Fast DDS message does not fit into its buffers.

## What it finds
A transport of a default participant whose `maxMessageSize` (65500 by default) is larger than one of these:
- `sendBufferSize` or `receiveBufferSize`, unless it is 0, which means the default of the kernel
- 65500, for UDP
- `segment_size` (524288 by default), for shared memory

## Why it matters on a robot
The library cannot register the transport and creates no participant: no ROS node starts.

## Bad
```xml
<type>UDPv4</type>
<sendBufferSize>32768</sendBufferSize>
```

## Good
```xml
<type>UDPv4</type>
<sendBufferSize>32768</sendBufferSize>
<maxMessageSize>8192</maxMessageSize>
```

## When to ignore it
Never: the library cannot create the participant.

## References
- Fast DDS 2.14.5, tested with the real library: exit status 1
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.fastdds import number
from bringup_lint.api.fastdds import used_transports


@rule(
    "error",
    symptoms=[
        "maxMessageSize cannot be greater than",
        "max_message_size cannot be greater than segment_size",
        "User transport failed to register",
    ],
)
def message_exceeds_buffer(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        used = used_transports(profiles) if not profiles.dropped else set()
        for transport in profiles.transports:
            name, kind = transport.find("transport_id"), transport.find("type")
            if name is None or kind is None or name.text not in used:
                continue
            largest = transport.find("maxMessageSize")
            size = number(largest, 65500)
            limits = (
                [("segment_size", 524288)] if kind.text == "SHM" else [("sendBufferSize", 0), ("receiveBufferSize", 0)]
            )
            for limit_name, default in limits:
                element = transport.find(limit_name)
                limit = number(element, default)
                if size is None or not limit or size <= limit:
                    continue
                where = next(each for each in (element, largest, transport) if each is not None)
                yield finding(
                    where.text,
                    f"Messages of {size} bytes do not fit {limit_name} {limit}: no participant can be "
                    "created, no node starts",
                    advice=f"raise {limit_name}, or lower maxMessageSize",
                )
            if largest is not None and kind.text.startswith("UDP") and size is not None and size > 65500:
                message = (
                    f"{size} bytes are more than a UDP message can carry (65500): no participant can be "
                    "created, no node starts"
                )
                yield finding(largest.text, message, advice="write 65500 or less")
