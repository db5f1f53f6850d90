"""A robot is set up differently from the others of its role.

## What it finds
What differs from what at least two thirds of the robots of one role have: a setting of a unit, a kernel parameter, a
parameter of a node, a version, `ROS_DISCOVERY_SERVER`, or the size of buffers or messages, the address of discovery or
the verbosity of Cyclone DDS. Names of the robots in values do not count as differences, nor does what is measured on
each robot: serial numbers, biases, offsets, files of calibrations, and decimal parameters that differ by at most one
part in fifty.

## Why it matters on a robot
Somebody changed one robot by hand, or an update did not reach it. What was tested on the others says nothing about this
one, and the change is lost with the next image.

## Bad
```ini
# alpha, beta: rover.service
Restart=on-failure
# gamma: rover.service
Restart=no
```

## Good
```ini
# alpha, beta, gamma: rover.service
Restart=on-failure
```

## When to ignore it
When the difference is meant: declare it in fleet.toml with `[[accept]]`, its rule, key, robots and reason, or give the
robot a role of its own.

## References
- systemd-delta(1) shows what differs from the files of the packages
- systemd.unit(5), sysctl.d(5)
"""

from collections.abc import Iterator

from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.fleet import Fleet
from bringup_lint.api.fleet import FleetFinding
from bringup_lint.api.fleet import difference
from bringup_lint.api.fleet import fleet_finding
from bringup_lint.api.fleet import names

_WHAT = {
    "setting": "unit",
    "kernel-parameter": "kernel parameter",
    "parameter": "parameter",
    "version": "version",
    "middleware": "variable",
    "security": "variable",
    "discovery": "variable",
    "dds": "DDS setting",
    "dds-setting": "DDS setting",
    "time-source": "time source",
}
"""What is compared."""
_DECIMAL = regex(r"-?\d{1,12}\.\d{1,12}")
_NEARLY = 0.02
_BY_SITE = {"middleware", "security", "discovery", "dds", "time-source"}
"""What other rules compare where the inventory says that the robots hear each other."""


@rule("warning", silent="no program compares the robots")
def drift(fleet: Fleet) -> Iterator[FleetFinding]:
    apart = [[robot for robot in robots if robot.talks != "shared"] for robots in fleet.roles.values()]
    for subject, what in _WHAT.items():
        for key, found in fleet.majorities(subject, apart if subject in _BY_SITE else fleet.roles.values()):
            role = found.usual[0].robot.role
            for value, odd in found.others.items():
                if subject == "parameter" and _is_measured(found.usual[0].fact.value, value):
                    continue
                total = len(found.usual) + sum(map(len, found.others.values()))
                yield fleet_finding(
                    [*odd, found.usual[0]],
                    f"{names(odd)} {'differs' if len(odd) == 1 else 'differ'} from {len(found.usual)} of {total}"
                    f" robots of the role {role} in the {what} {key}".rstrip(),
                    advice="bring it in line, or declare it in fleet.toml: [[accept]]",
                    difference=difference(key or what, found.usual, odd),
                )


def _is_measured(usual: str, value: str) -> bool:
    """Whether two numbers are nearly the same, as a wheel radius is on robots of one role."""
    if not (_DECIMAL.fullmatch(usual) and _DECIMAL.fullmatch(value)):
        return False
    return abs(float(usual) - float(value)) <= _NEARLY * abs(float(usual))
