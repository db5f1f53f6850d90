"""NoNewPrivileges= cancels the capabilities that setcap grants.

## What it finds
NoNewPrivileges=yes on a service that starts a program to which a script or build file of the tree gives file
capabilities with `setcap`, when AmbientCapabilities= does not grant the same capabilities.

## Why it matters on a robot
File capabilities are privileges gained on exec, which NoNewPrivileges= forbids. The EtherCAT master or the
CAN tool runs without CAP_NET_RAW and cannot open its socket, but only as a service.

## Bad
```ini
# the build: setcap cap_net_raw+ep /opt/rover/bin/ethercat-master
[Service]
User=rover
ExecStart=/opt/rover/bin/ethercat-master
NoNewPrivileges=yes
```

## Good
```ini
[Service]
User=rover
ExecStart=/opt/rover/bin/ethercat-master
AmbientCapabilities=CAP_NET_RAW
NoNewPrivileges=yes
```

## When to ignore it
When the program does not need the capability in this service, for example because it only runs in a
simulation mode.

## References
- systemd.exec(5), NoNewPrivileges=; capabilities(7), "File capabilities"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import file_capabilities


@rule("warning", symptoms=["Operation not permitted", "could not open raw socket"])
def nnp_filecaps(robot: Robot) -> Iterator[Finding]:
    units = [unit for unit in robot.units.services if unit.flag("NoNewPrivileges") and unit.identity.is_other]
    given = file_capabilities(robot.files) if units else {}
    for unit in units:
        ambient = {str(word).upper() for word in unit.words("AmbientCapabilities")}
        for process in robot.units.started(unit):
            names = {step.command.name: step.command.words[0] for step in process.steps if step.command.words}
            names |= {
                str(found.where).rpartition("/")[2]: found.where for _, found in process.ros if found.kind != "launch"
            }
            for name, where in names.items():
                lost = [(capability, at) for capability, at in given.get(name, ()) if capability not in ambient]
                if not lost:
                    continue
                wanted = " ".join(dict.fromkeys(capability for capability, _ in lost))
                at = unit.flag("NoNewPrivileges").where
                yield finding(
                    at,
                    f"NoNewPrivileges= makes {name} run without {wanted}, which setcap grants it",
                    advice=f"set AmbientCapabilities={wanted}",
                    related=[note(where, "the program"), note(lost[0][1], "grants the file its capabilities")],
                )
