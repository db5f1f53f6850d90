"""Nothing creates a path of the sandbox.

## What it finds
A path without `-` in ReadWritePaths=, ReadOnlyPaths=, BindPaths= or BindReadOnlyPaths= that nothing in the
tree creates: no tmpfiles.d line, no LogsDirectory=, StateDirectory= or similar setting, no mount and no
script.

- In a complete root file system, every path is checked.
- In a repository, only paths below /var/log, /var/lib, /run and similar folders are checked, where nothing
  exists by default.
- A device on USB (`ttyUSB0`, `ttyACM0`, `video0`, `js0`, names in `by-id`, links that udev rules of the tree make of
  one) is a warning in ReadWritePaths= of a unit that a target starts. Other devices are an info, and so are these where
  a unit of the tree names the device unit, where the unit names any device unit, has a condition on /dev or a command
  before the start with the prefix `+`, or where a path unit, a timer or udev starts it.

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
USB = regex(
    r"/dev/(?:ttyUSB\d+|ttyACM\d+|video\d|(?:input/)?js\d+|(?:serial|v4l|input)/by-id/usb-.+)",
)
"""What a device on USB is called; the codecs of a Raspberry Pi begin with video10."""
KERNEL = regex(r"ttyUSB|ttyACM")
TESTS = ("Condition", "Assert")
STARTING = regex(r"\bSYSTEMD_(?:USER_)?WANTS\b|\bsystemctl\b|\bsystemd-run\b", hints="SYSTEMD_ system")
"""A rule of udev that starts units."""
OUTSIDE = regex(r"[-@:!|]*\+")
"""Begins a command that runs without the sandbox."""
BEFORE = ("ExecStartPre", "ExecCondition")


@rule(
    "warning",
    fix="unsafe",
    symptoms=["Failed to set up mount namespacing", "status=226/NAMESPACE", "Failed at step NAMESPACE spawning"],
)
def readwritepaths_missing(robot: Robot) -> Iterator[Finding]:
    started = any(STARTING.search(source.said) for source in robot.of_kind("udev-rules"))
    awaited = {path for each in robot.units.all for word in _device_units(each) if (path := device_path(word))}
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
                may_lack = device and key == KEYS[0] and not started and path not in awaited
                may_lack = may_lack and _is_usb(robot, path) and _starts_anyway(robot, unit)
                yield finding(
                    word,
                    f"When {path} does not exist, {unit.name} does not start: 226/NAMESPACE"
                    if device
                    else f"Nothing creates {path}: {unit.name} does not start, 226/NAMESPACE",
                    advice=_advice(path, device),
                    fix=fix(f"write -{path}", (word.part(0, 0), "-")) if unit.editable else None,
                    severity="info" if device and not may_lack else "warning",
                    confidence="high" if robot.tree.complete and not device else "medium",
                )


def _is_usb(robot: Robot, path: str) -> bool:
    """Whether a path is of a device that may be unplugged, by its name or by the rules of udev that make it."""
    if USB.fullmatch(path):
        return True
    links = [link for link in robot.udev.links_to(path) if link.is_fixed]
    return bool(links) and all(link.rule.usb_ids or any(map(KERNEL.match, link.rule.kernels)) for link in links)


def _starts_anyway(robot: Robot, unit: Unit) -> bool:
    """Whether a unit is started at boot, and nothing asks for a device before."""
    targets = [*unit.words("WantedBy", "Install"), *unit.words("RequiredBy", "Install")]
    if not any(word.endswith(".target") for word in targets) or unit.name in robot.units.triggered:
        return False
    if any(True for _ in _device_units(unit)):
        return False
    if any(OUTSIDE.match(value) for key in BEFORE for value in unit.values(key)):
        return False
    settings = (each for file in unit.files for each in file.assignments)
    return not any(each.key.startswith(TESTS) and "/dev" in each.value for each in settings)


def _device_units(unit: Unit) -> Iterator[str]:
    """The device units that a unit names, be it in [Install]."""
    for file in unit.files:
        for each in file.assignments:
            if ".device" in each.value:
                yield from (word for word in each.value.split() if word.endswith(".device"))


def _advice(path: str, device: bool) -> str:
    made = None if device else line_to_create(path)
    return f"let systemd create it with {made}, or write -{path}" if made else f"write -{path}"
