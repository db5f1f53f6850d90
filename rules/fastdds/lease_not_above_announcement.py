"""A Fast DDS lease expires before it is renewed.

## What it finds
A default participant whose `leaseDuration` (20 s by default) is not longer than its `leaseAnnouncement` (3 s
by default).

## Why it matters on a robot
The library refuses to create the participant: no ROS node starts. The usual cause is a short lease that
should detect lost robots quickly.

## Bad
```xml
<leaseDuration>
  <sec>2</sec>
</leaseDuration>
```

## Good
```xml
<leaseDuration>
  <sec>2</sec>
</leaseDuration>
<leaseAnnouncement>
  <nanosec>500000000</nanosec>
</leaseAnnouncement>
```

## When to ignore it
Never: the library refuses to create the participant.

## References
- Fast DDS 2.14.5, tested with the real library: exit status 1
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.fastdds import seconds


@rule("error", symptoms=["LeaseDuration should be >= leaseDuration announcement period"])
def lease_not_above_announcement(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        for participant in profiles.default_participants:
            for element in participant.walk():
                if element.name != "discovery_config":
                    continue
                lease = seconds(element.find("leaseDuration"), 20)
                period = seconds(element.find("leaseAnnouncement"), 3)
                if lease is None or period is None or lease > period:
                    continue
                written = [element.find("leaseDuration"), element.find("leaseAnnouncement")]
                where, *others = [each for each in written if each is not None]
                yield finding(
                    where.name,
                    f"The lease of {lease:g} s is not longer than the announcement period of {period:g} s: "
                    "no node starts",
                    advice="announce at least twice within a lease",
                    related=[note(each.name, "the announcement period") for each in others],
                )
