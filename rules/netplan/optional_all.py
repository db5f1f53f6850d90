"""Every interface is optional although units wait for the network.

## What it finds
`optional: true` on every interface of the plan, while a unit is ordered after `network-online.target`: a warning when
the unit takes part in DDS, else an info, because a server on all interfaces needs no address.
Nothing is reported if a drop-in configures the wait-online service, or if NetworkManager renders an
interface, because it ignores `optional`.

## Why it matters on a robot
`network-online.target` is reached at once, without an address. From netplan 1.1 on, wait-online does not even
start. DDS binds to an interface that has no address yet, or to none.

## Bad
```yaml
ethernets:
  eth0: {dhcp4: true, optional: true}
```

## Good
```yaml
ethernets:
  eth0: {dhcp4: true}
  eth1: {dhcp4: true, optional: true}
```

## When to ignore it
If DDS uses the loopback interface only and nothing else needs an address at start.

## References
- netplan YAML reference, "optional"
- systemd.special(7), "network-online.target"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="the units that wait for the network just start before it is there")
def optional_all(robot: Robot) -> Iterator[Finding]:
    waiting = robot.waiting_for_network
    plan = robot.netplan.only_plan
    if not waiting or plan is None or not plan.is_waited_for:
        return
    interfaces = [i for i in plan.interfaces.values() if i.name not in plan.masters]
    flags = [i.optional for i in interfaces]
    optional = [flag for flag in flags if flag is not None and flag.value]
    if interfaces and len(optional) == len(interfaces):
        of_dds = {unit.name for unit in (*robot.units.dds, *robot.units.presumed_ros)}
        name, word = next((each for each in waiting if each[0] in of_dds), waiting[0])
        yield finding(
            optional[0].where,
            f"Every interface is optional: {name} starts before any of them has an address",
            advice="remove optional: true from the interface that DDS needs",
            related=[note(word, f"{name} waits for the network here")],
            severity=None if name in of_dds else "info",
        )
