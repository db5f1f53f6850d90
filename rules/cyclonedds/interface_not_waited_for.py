"""The DDS interface may not be up when ROS starts.

## What it finds
Cyclone DDS names an interface that the robot's netplan marks `optional: true`: the boot does not wait
for it. `presence_required="false"` beside other interfaces is left alone.

## Why it matters on a robot
The interface is not there yet when the nodes start: `does not match an available interface`, and no
node starts. By hand, minutes later, everything works. Participants never pick up an interface that
appears later.

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

## References
- netplan YAML reference, "optional"
- Cyclone DDS 0.10.5 and 11.0.1, tried with the real library
- https://github.com/tier4/edge-auto-jetson/pull/82
"""

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", confidence="medium", symptoms=["does not match an available interface"])
def interface_not_waited_for(robot: Robot):
    for configuration, domain in robot.dds.domains:
        plan = robot.dds.plan_of(configuration)
        names = list(robot.dds.named_interfaces(domain)) if plan else []
        for setting in names:
            interface = robot.dds.device(plan, setting.effective)
            required = domain.of(setting.owner, "presence_required")
            if required is not None and (required.effective or "false").lower() == "false" and len(names) > 1:
                continue
            if interface is not None and interface.optional is not None and interface.optional.value:
                yield finding(
                    setting.value,
                    f"The boot does not wait for {setting.effective}: when ROS starts first, no node starts",
                    advice="delete optional, and start ROS after network-online.target",
                    related=[note(interface.optional.where, "netplan does not wait for it")],
                )
