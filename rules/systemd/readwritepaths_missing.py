"""Nothing creates a path of the sandbox.

## What it finds
A path without `-` in ReadWritePaths=, ReadOnlyPaths=, BindPaths= or BindReadOnlyPaths= that nothing in the
tree creates: no tmpfiles.d line, no LogsDirectory=, StateDirectory= or similar setting, no mount and no
script.

- In a complete root file system, every path is checked.
- In a repository, only paths below /var/log, /var/lib, /run and similar folders are checked, where nothing
  exists by default.
- A device node that may be unplugged is a warning in ReadWritePaths=, where the unit neither depends on its device unit
  nor checks that it exists: /dev is writable without the line, whatever ProtectSystem= says. Else it is an info.

## Why it matters on a robot
systemd cannot set up the mount namespace, and the service does not start: 226/NAMESPACE. It works on the
developer's robot, where somebody created the directory by hand, and fails on the next one.

## Bad
```ini
[Service]
ProtectSystem=strict
ReadWritePaths=/var/log/rover
```

## Good
```ini
[Service]
ProtectSystem=strict
LogsDirectory=rover
```

## When to ignore it
When another package or a provisioning step that is not in this tree creates the path before the service
starts.

## References
- systemd.exec(5), ReadWritePaths= (the `-` prefix), ProtectSystem= ("except for the API file system subtrees /dev/")
  and LogsDirectory=
- tmpfiles.d(5)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.host import device_path
from bringup_lint.api.host import is_link_by_form
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import line_to_create
from bringup_lint.api.systemd import paths

KEYS = ("ReadWritePaths", "ReadOnlyPaths", "BindPaths", "BindReadOnlyPaths")
ALWAYS = (
    "/dev/null",
    "/dev/shm",
    "/dev/mqueue",
    "/dev/pts",
    "/dev/input",
    "/dev/bus",
    "/dev/net/tun",
    "/dev/dri",
    "/dev/snd",
)
ADAPTER = regex(r"/dev/(?:ttyUSB|ttyACM|video|serial/|v4l/)")
"""What a device on USB is called."""
PULLS = ("BindsTo", "Requires", "Wants", "Requisite")
CHECKS = ("ConditionPathExists", "AssertPathExists")


@rule(
    "warning",
    fix="unsafe",
    symptoms=["Failed to set up mount namespacing", "status=226/NAMESPACE", "Failed at step NAMESPACE spawning"],
)
def readwritepaths_missing(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.judged:
        box = robot.units.sandbox(unit)
        if not unit.complete or box.own_root:
            continue
        for key in KEYS:
            for word, path, optional in paths(unit, key):
                view = box.view(path)
                if optional or (view is not None and view.mode == "hidden"):
                    continue
                device = path.startswith("/dev/")
                if path.startswith(ALWAYS) if device else robot.filesystem.is_created(path, unit) is not False:
                    continue
                yield finding(
                    word,
                    f"When {path} does not exist, {unit.name} does not start: 226/NAMESPACE"
                    if device
                    else f"Nothing creates {path}: {unit.name} does not start, 226/NAMESPACE",
                    advice=_advice(path, device),
                    fix=fix(f"write -{path}", (word.part(0, 0), "-")) if unit.editable else None,
                    severity="info" if device and not (key == KEYS[0] and _may_lack(path, unit)) else "warning",
                    confidence="high" if robot.tree.complete and not device else "medium",
                )


def _may_lack(path: str, unit: Unit) -> bool:
    """Whether a device may be unplugged, and the unit starts all the same."""
    if ADAPTER.match(path) is None and not is_link_by_form(path):
        return False
    is_awaited = any(device_path(word) == path for key in PULLS for word in unit.words(key))
    return not is_awaited and not any(str(unit.get(key, "Unit")) == path for key in CHECKS)


def _advice(path: str, device: bool) -> str:
    made = None if device else line_to_create(path)
    return f"let systemd create it with {made}, or write -{path}" if made else f"write -{path}"
