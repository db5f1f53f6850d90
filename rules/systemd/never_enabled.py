"""An installed unit that nothing enables.

## What it finds
A service with WantedBy=multi-user.target that a script or a play of Ansible writes or copies to
`/etc/systemd/system`, where no `systemctl enable`, no task with `enabled: true`, no preset, no other unit and no guide
of the tree enables or starts it. Silent where something enables units whose names are not known.

## Why it matters on a robot
`WantedBy=` has an effect only when the unit is enabled. After the installation everything looks complete, and after
the next boot the robot's software does not run.

## Bad
```sh
sudo cp rover.service /etc/systemd/system/
sudo systemctl daemon-reload
```

## Good
```sh
sudo cp rover.service /etc/systemd/system/
sudo systemctl daemon-reload
sudo systemctl enable --now rover.service
```

## When to ignore it
When somebody enables the unit by hand on each robot that needs it.

## References
- systemctl(1), "enable"
- systemd.unit(5), "[Install] Section Options"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.systemd import installed_at
from bringup_lint.api.systemd import never_enabled_units

INSTALLING = ("shell-script", "ansible", "cloud-init")


@rule("warning", confidence="medium", silent="systemd loads the unit and waits for somebody to start it")
def never_enabled(robot: Robot) -> Iterator[Finding]:
    units = never_enabled_units(robot.files, robot.units) if robot.of_kind(*INSTALLING) else ()
    for unit in units:
        wanted = unit.words("WantedBy", "Install")[0]
        yield finding(
            wanted,
            f"{unit.name} is installed, but nothing enables it: WantedBy= has no effect, and it does not start at boot",
            advice=f"run systemctl enable {unit.name} after the installation",
            related=[
                note(unit.where, "the unit"),
                *(note(each, "it is put into place here") for each in installed_at(robot.files, unit)),
            ],
        )
