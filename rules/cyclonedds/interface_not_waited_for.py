"""The DDS interface may not be up when ROS starts.

## What it finds
Cyclone DDS names an interface that the robot's netplan marks `optional: true`, so the boot does not wait for
it. No unit that reads the file waits for the interface itself: through its device unit, with wait-online, or
in a script. `presence_required="false"` is not reported if other interfaces are listed too.

## Why it matters on a robot
The interface does not exist yet when the nodes start: `does not match an available interface`, and no node
starts. Started by hand minutes later, everything works. Participants never pick up an interface that appears
later.

## Bad
```xml
# netplan
eth0:
  optional: true
```

## Good
```xml
# netplan
eth0:
  optional: false
```

## When to ignore it
If the service restarts until the interface is up (`Restart=on-failure`) and that delay is acceptable.

## References
- netplan YAML reference, "optional"
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
- https://github.com/tier4/edge-auto-jetson/pull/82
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.dds import Configuration
from bringup_lint.api.dds import interface_of_device
from bringup_lint.api.dds import named_interfaces


@rule("error", confidence="medium", symptoms=["does not match an available interface"])
def interface_not_waited_for(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        if plan is None:
            continue
        names = list(named_interfaces(domain))
        for setting in names:
            name = str(setting.effective)
            interface = interface_of_device(plan, name)
            required = domain.of(setting.owner, "presence_required")
            if required is not None and (required.effective or "false").lower() == "false" and len(names) > 1:
                continue
            optional = interface.optional if interface is not None else None
            if optional is not None and optional.value and not robot.dds.waits_for(configuration, name):
                yield finding(
                    setting.value,
                    f"The boot does not wait for {setting.effective}: if ROS starts first, no node starts",
                    advice="delete optional, and start ROS after network-online.target",
                    related=[note(optional.where, "netplan does not wait for it"), *_order(robot, configuration)],
                    chain=robot.provenance.chain_to(setting.value, f"DDS uses {setting.effective}"),
                )


def _order(robot: Robot, configuration: Configuration) -> list[Related]:
    """What the units that read the file wait for instead."""
    found = [reader.process.unit for reader in robot.dds.readers(configuration)]
    units = {unit.name: unit for unit in found if unit is not None}
    words = [(unit, word) for unit in units.values() for word in unit.words("After") if "network" in word]
    return [note(word, f"{unit.name} waits for {word} only") for unit, word in words[:3]]
