"""Certificates of many robots end on the same day.

## What it finds
Certificates of at least three robots, and of half of those that have some, that end on one day.

## Why it matters on a robot
All robots of the batch lose the fleet server, the broker or SROS 2 in the same night, and none of them can be reached
to get a new one.

## Bad
```text
alpha/etc/mosquitto/certs/client.crt   until 2027-03-01
beta/etc/mosquitto/certs/client.crt    until 2027-03-01
gamma/etc/mosquitto/certs/client.crt   until 2027-03-01
```

## Good
```text
alpha/etc/mosquitto/certs/client.crt   until 2027-03-01
beta/etc/mosquitto/certs/client.crt    until 2027-03-19
gamma/etc/mosquitto/certs/client.crt   until 2027-04-06
```

## When to ignore it
When certificates renew themselves long before their last day.

## References
- RFC 5280, section 4.1.2.5: validity
- [SROS 2 keystores](https://github.com/ros2/sros2): certificates of one call of create_enclave end together
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import BY_VALUE
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names

_FEWEST = 3


@rule("warning", silent="the certificates are valid until that day")
def certificates_end_together(fleet: Fleet) -> Iterator[FleetFinding]:
    holders = {each.robot.name for each in fleet.stated("certificate")}
    for group in fleet.alike("certificate", BY_VALUE):
        day = group[0].fact.value
        if len(group) >= _FEWEST and 2 * len(group) >= len(holders):
            yield fleet_finding(
                group,
                f"Certificates of {len(group)} robots end on {day}: {names(group)}; none connects after that day",
                advice="renew them in turns, some weeks before the end, and spread the days",
            )
