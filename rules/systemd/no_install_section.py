"""A service that cannot be enabled and that nothing starts.

## What it finds
A service without `[Install]`, or with an empty one (a warning), that no other unit, link, timer, socket, path or udev
rule of the tree starts.

## Why it matters on a robot
`systemctl enable` only reports that the unit is static. After the next boot the service does not run.

## Bad
```ini
[Service]
ExecStart=/opt/rover/bin/base
```

## Good
```ini
[Service]
ExecStart=/opt/rover/bin/base

[Install]
WantedBy=multi-user.target
```

## When to ignore it
When the service is only ever started by hand, by a script or by a program through D-Bus.

## References
- systemd.unit(5), "[Install] Section Options"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule

ENABLES = ("enable", "reenable")


@rule("info", fix="unsafe", symptoms=["The unit files have no installation config"])
def no_install_section(robot: Robot) -> Iterator[Finding]:
    units = robot.units
    without = [
        (unit, file.source)
        for unit in units.services
        if (file := unit.fragment) is not None and file.source.judged and not (unit.uncertain or units.is_started(unit))
    ]
    named = _enabled(robot) if without else {}
    for unit, source in without:
        target = "multi-user.target" if unit.manager == "system" else "default.target"
        enabled = [word for word in named.get(unit.name, ()) if robot.same_robot(word, source)]
        empty = next(iter(unit.sections("Install")), None)
        lacks = "has no [Install] section" if empty is None else "has an empty [Install] section"
        yield finding(
            unit.where if empty is None else empty.name,
            f"{unit.name} {lacks}, and nothing starts it: systemctl enable has no effect",
            advice=f"add {'[Install] with ' if empty is None else ''}WantedBy={target}",
            severity="warning" if enabled or empty is not None else None,
            related=[note(word, "enabled here, in vain") for word in enabled[:20]],
            fix=fix("add an [Install] section", unit.new_line("Install", f"WantedBy={target}"), safe=False),
        )


def _enabled(robot: Robot) -> dict[str, list[Located]]:
    """Service -> where scripts enable it."""
    found: dict[str, list[Located]] = {}
    for _, run in robot.scripts.run("systemctl"):
        if any(verb in run.words for verb in ENABLES):
            for word in run.words[1:]:
                name = run.text(word) or ""
                found.setdefault(f"{name.removesuffix('.service')}.service", []).append(word)
    return found
