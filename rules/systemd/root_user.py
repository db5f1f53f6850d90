"""The robot's software runs as root.

## What it finds
A service of the system manager that runs as root (`User=` is not set or is root, and there is no
`DynamicUser=`), or a command with the prefix `+`, that starts one of these:

- ROS;
- in a long-running service: an interpreter with a script of the robot;
- a program in somebody's home folder;
- in a long-running service: a plain network relay such as socat;
- with the prefix `+`, where `User=` or `DynamicUser=` is set: any program of a service that is not oneshot.

`User=root` is an info where a comment of the unit, or a page of the tree that names it, says that it runs as root or
needs root, and no other user runs ROS; so it is where a node of the tree drives LEDs through `rpi_ws281x`, or opens
`/dev/mem`, unless the unit starts other packages only.

Commands that change the user themselves, containers, and programs whose XAUTHORITY= is a file of root are exempt.

## Why it matters on a robot
Every node, every message parser and every script may then write firmware, change the network and read keys:
one bug in a driver compromises the whole robot. The robot's user cannot change files that root wrote (logs,
maps, caches). The shared memory of Fast DDS that root creates is closed to nodes of other users: topics are
listed, but data never arrives. A program below `/home` is worse: the owner of that home decides what root
runs.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## Good
```ini
[Service]
User=rover
SupplementaryGroups=dialout video
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover_bringup rover.launch.py'
```

## When to ignore it
When the program needs full root and does little else, for example a flashing or provisioning tool. For a
driver, grant groups and capabilities instead.

## References
- systemd.exec(5), "User="
- <https://github.com/eProsima/Fast-DDS/issues/5258>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import NeedlessRoot
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Work
from bringup_lint.api.systemd import changes_user
from bringup_lint.api.systemd import needless_root
from bringup_lint.api.systemd import reads_display_of_root

TEXTS = {
    Work.ROS: "ROS",
    Work.PROBABLY_ROS: "{name} (probably ROS: it is not in this tree)",
    Work.IN_HOME: "{name}, which user {owner} can change,",
    Work.SET_UP_IN_HOME: "{name}, which user {owner} can change,",
    Work.OWN_SCRIPT: "{name}",
    Work.OWN_PROGRAM: "{name}",
    Work.RELAY: "{name}, which needs no root,",
}
CERTAIN = (Work.ROS, Work.IN_HOME, Work.SET_UP_IN_HOME)
OWN_USER = "add a User= of its own, and SupplementaryGroups= for the devices that it opens"
PAGE = regex(r".*\.(?:md|rst|txt)")
PAGE_SIZE = 200_000
AS_ROOT = regex(r"(?i:\b(?:as|needs?|requires?)\W{1,4}root\b)")
REGISTERS = regex(r"(?m)^[ \t]*(?:import|from)[ \t]+(?:neopixel|rpi_ws281x)\b|[\"']/dev/mem[\"']|\bws2811_init\b")
"""LEDs that are driven by PWM and DMA of a Raspberry Pi, and the memory of the machine itself."""
MOVE = "move it to /usr/local/sbin, where only root may write"


@rule(
    "warning",
    fix="unsafe",
    tags=["CWE-250"],
    symptoms=["$HOME is not set", "Failed to get logging directory"],
)
def root_user(robot: Robot) -> Iterator[Finding]:
    others = {unit.identity.name for unit in robot.units.ros if unit.identity.is_other}
    for unit in robot.units.services:
        is_root = unit.identity.is_root
        if unit.manager == "user" or is_root is None or reads_display_of_root(unit, robot.units):
            continue
        for process in robot.units.started(unit):
            if not (is_root or "+" in process.prefixes) or changes_user(process):
                continue
            needless = needless_root(process, robot.units)
            if is_root and needless is not None:
                is_meant = (not others and _is_explained(robot, unit)) or _is_needed(robot, unit, needless)
                yield _without_user(unit, needless, others, "info" if is_meant else None)
            elif not is_root and (needless is not None or unit.get("Type") != "oneshot"):
                yield _with_idle_user(unit, process, needless)
            else:
                continue
            break


def _is_explained(robot: Robot, unit: Unit) -> bool:
    """Whether User=root is written, and a comment of the unit or a page that names it says that it is to be root."""
    user = unit.identity.user
    if user is None:
        return False
    comments = (line for line in user.span.source.text.splitlines() if line.startswith(("#", ";")))
    pages = robot.tree.pages(PAGE, PAGE_SIZE)
    naming = (line for page in pages for line in page.splitlines() if unit.name in line)
    return any(AS_ROOT.search(line) for lines in (comments, naming) for line in lines)


def _is_needed(robot: Robot, unit: Unit, needless: NeedlessRoot) -> bool:
    """Whether User=root is written, and a node that the unit may start writes to registers, which root alone may."""
    if unit.identity.user is None or needless.work is not Work.ROS:
        return False
    nodes = [each for each in robot.of_kind("python-node", "cpp-node", "cpp-driver") if each.matches(REGISTERS)]
    owners = (robot.launch.workspace.owner(each) for each in nodes)
    names = {None if owner is None else owner.name for owner in owners}
    if not names:
        return False
    started = robot.runners.packages_of(unit)
    return None in names or None in started or not names.isdisjoint(started)


def _without_user(unit: Unit, needless: NeedlessRoot, others: set[str | None], severity: str | None) -> Finding:
    user = unit.identity.user
    sets_up = needless.work is Work.SET_UP_IN_HOME
    return finding(
        user or unit.where,
        f"{unit.name} runs {_text(needless)} as root" + ("" if user else ": it has no User="),
        advice=MOVE if sets_up else OWN_USER,
        related=[note(needless.where, "the unit starts it here")],
        fix=None if sets_up else _fix(unit, others),
        severity=severity,
        confidence="high" if needless.work in CERTAIN else "medium",
    )


def _with_idle_user(unit: Unit, process: Process, needless: NeedlessRoot | None) -> Finding:
    set_user = unit.identity.user or unit.identity.dynamic.at
    says = f"User={unit.identity.user}" if unit.identity.user else "DynamicUser="
    return finding(
        process.program,
        f"'+' runs {_text(needless) if needless is not None else process.program} as root, whatever {says} says",
        advice="remove the '+'",
        related=[note(set_user, "has no effect here")] if set_user else (),
    )


def _text(needless: NeedlessRoot) -> str:
    name = needless.where.rpartition("/")[2] if needless.work is Work.RELAY else needless.where
    return TEXTS[needless.work].format(name=name, owner=needless.owner)


def _fix(unit: Unit, others: set[str | None]) -> Fix | None:
    """The user of the other ROS services, when they have one in common."""
    if len(others) != 1:
        return None
    (name,) = others
    user = unit.identity.user
    return fix(
        f"run it as {name}, like the other ROS services",
        (user, str(name)) if user else unit.new_line("Service", f"User={name}"),
        safe=False,
    )
