"""A user unit that names a unit of the system manager.

## What it finds
A unit of the user manager (`/etc/systemd/user`, `~/.config/systemd/user`) that names a target of the system
manager, such as `multi-user.target` or `network-online.target`, and that is not beside it:

- error: in WantedBy=, RequiredBy=, Requires= or BindsTo=;
- warning: in After= or Wants=, where it names the network, a mount or the clock, for which the unit does not wait;
- info: in After= or Wants=, where it names another one.

It is a warning in WantedBy= and RequiredBy= of a unit that a script or a playbook of the tree starts by its name, and
an info where the playbook says `enabled: false`.

## Why it matters on a robot
The user manager does not have this unit. With `WantedBy=multi-user.target` the service never starts. With
`After=network-online.target` it does not wait. With `Requires=` it fails.

## Bad
```ini
# ~/.config/systemd/user/rviz.service
[Install]
WantedBy=multi-user.target
```

## Good
```ini
# ~/.config/systemd/user/rviz.service
[Install]
WantedBy=default.target
```

## When to ignore it
When a user unit of the same name exists on the robot, outside of this tree.

## References
- systemd.special(7), "Units managed by the user service manager"
"""

import posixpath
from collections.abc import Iterator
from functools import partial

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Unit

SYSTEM_ONLY = frozenset(
    f"{name}.target"
    for name in "multi-user graphical sysinit network network-online network-pre nss-lookup "
    "local-fs remote-fs time-sync time-set "
    "rescue emergency getty swap cryptsetup systemd-networkd nss-user-lookup".split()
)

WAITED_FOR = regex(r"network|nss-|local-fs|remote-fs|time-s")
OFF = regex(
    r"\bname:[ \t]*[\"']?(?P<name>[^\s\"']+)[\"']?[ \t]*\n"
    r"(?=(?:[ \t]+\w+:[^\n]*\n){0,6}?[ \t]+enabled:[ \t]*(?:false|no)\b)",
    hints="enabled:",
)
"""A task that says of a unit that it shall not start by itself."""
"""What a service orders itself after because it needs it."""


@rule("error", fix="unsafe", symptoms=["is added as a dependency to a non-existent unit multi-user.target."])
def user_unit_system_target(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        if unit.manager != "user":
            continue
        folders = {posixpath.dirname(file.source.name) for file in unit.files}
        beside = {name for name in SYSTEM_ONLY for each in folders if robot.tree.exists(posixpath.join(each, name))}
        names = SYSTEM_ONLY - beside
        for key, section in (
            ("WantedBy", "Install"),
            ("RequiredBy", "Install"),
            ("Requires", "Unit"),
            ("BindsTo", "Unit"),
        ):
            for _, word in unit.naming(key, *names, section=section):
                installs = section == "Install"
                started = installs and robot.units.is_started_by_script(unit)
                yield finding(
                    word,
                    f"The user manager has no {word}: {_consequence(unit, key, installs, started)}",
                    advice="write WantedBy=default.target"
                    if installs
                    else f"remove {key}={word}, or make it a system unit",
                    fix=fix("write default.target", (word, "default.target")) if installs else None,
                    severity=_severity(robot, unit) if started else None,
                )
        for key in ("After", "Wants"):
            for line, word in unit.naming(key, *names):
                yield finding(
                    word,
                    f"The user manager has no {word}: this {key}= has no effect",
                    advice="remove it, or make it a system unit with User=",
                    fix=fix(f"remove {key}={word}", line.without(word)),
                    severity="warning" if WAITED_FOR.match(word) else "info",
                )


def _severity(robot: Robot, unit: Unit) -> str:
    """Of what is started by a script: an Ansible task may say that it shall not start by itself."""
    is_off = any(unit.stem in each.once(OFF, partial(_off, each)) for each in robot.of_kind("ansible"))
    return "info" if is_off else "warning"


def _off(source: Source) -> set[str]:
    """What tasks name, without its ending, that shall not start by itself."""
    return {match["name"].removesuffix(".service") for match in OFF.finditer(source.text)}


def _consequence(unit: Unit, key: str, installs: bool, started: bool) -> str:
    if started:
        return f"{key}= has no effect, and {unit.name} runs only when somebody starts it"
    return f"{unit.name} never starts" if installs else f"{unit.name} fails to start"
