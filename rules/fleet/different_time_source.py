"""Robots that must hear each other take the time from different sources.

## What it finds
Other servers in `chrony.conf` or `timesyncd.conf` than most robots have, in a site of which fleet.toml says
`domains = "shared"`.

## Why it matters on a robot
Clocks that follow different sources drift apart by more than a message is late: tf refuses transforms of the other
robot as too old or too new, and certificates that are valid on one are not yet on the other.

## Bad
```text
alpha, beta: server 10.0.0.1 iburst
gamma:       pool pool.ntp.org iburst
```

## Good
```text
alpha, beta, gamma: server 10.0.0.1 iburst
```

## When to ignore it
When the sources follow each other closely, as GPS receivers do.

## References
- chrony.conf(5), `server`, `pool`
- timesyncd.conf(5), `NTP=`
"""

from collections.abc import Iterator

from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import difference
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names


@rule("warning", silent="each clock is synchronised; no program compares them")
def different_time_source(fleet: Fleet) -> Iterator[FleetFinding]:
    for _, found in fleet.majorities("time-source", fleet.talking()):
        for value, odd in found.others.items():
            yield fleet_finding(
                [*odd, found.usual[0]],
                f"{names(odd)} {'takes' if len(odd) == 1 else 'take'} the time from {value}, and the other robots"
                f" of the site from {found.usual[0].fact.value}: their clocks drift apart",
                advice="let all robots of a site follow one source",
                difference=difference("time servers", found.usual, odd),
            )
