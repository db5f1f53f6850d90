"""The unit names one ROS distribution and sources another.

## What it finds
A mix of ROS distributions in one service:

- a process sources `/opt/ros/<distro>/setup.*`, or starts a program below it, while `ROS_DISTRO` in its
  environment (unit, environment files, earlier exports) names another distribution: a warning, because the setup file
  sets the variable anew;
- one process sources two distributions: an error.

## Why it matters on a robot
After an upgrade, half of the files still name the old release. Libraries of two releases do not mix: nodes
crash with undefined symbols or do not understand messages. Anything that builds paths from `ROS_DISTRO` looks
in the wrong place.

## Bad
```ini
[Service]
Environment=ROS_DISTRO=jazzy
ExecStart=/bin/bash -c 'source /opt/ros/humble/setup.bash && exec ros2 launch rover rover.launch.py'
```

## Good
```ini
[Service]
Environment=ROS_DISTRO=jazzy
ExecStart=/bin/bash -c 'source /opt/ros/${ROS_DISTRO}/setup.bash && exec ros2 launch rover rover.launch.py'
```

## When to ignore it
When the process is a bridge of your own that uses two distributions on purpose. Processes that run `ros1_bridge` are
not reported: it needs ROS 1 and ROS 2, in this order.

## References
- REP 2000, releases and target platforms
- https://github.com/ros2/ros1_bridge, "Example 1: run the bridge and the example talker and listener"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Step
from bringup_lint.api.systemd import Unit
from bringup_lint.api.systemd import Variable

BRIDGE = "ros1_bridge"
DISTRO = regex(r"/opt/ros/([a-z]+)(?:/|$)", hints="/opt/ros/")


@rule("error", symptoms=["undefined symbol: _ZN", "Package not found"])
def ros_distro_mismatch(robot: Robot) -> Iterator[Finding]:
    if not robot.may_hold("/opt/ros/"):
        return
    units = robot.units
    for unit in units.services:
        for process in units.processes(unit):
            if any(BRIDGE in step.command.words for step in process.steps):
                continue
            named = units.environment(unit).get("ROS_DISTRO")
            chosen = (named.value, named.text) if named and named.text else None
            for step, word in paths(process):
                match = DISTRO.match(word)
                distro = match[1] if match else ""
                if chosen is None:
                    chosen = (word, distro)
                elif distro != chosen[1]:
                    yield _finding(unit, process, step, word, distro, chosen, named if chosen[0] != word else None)
                    break


def _finding(
    unit: Unit,
    process: Process,
    step: Step,
    word: Located,
    distro: str,
    chosen: tuple[Located, str],
    named: Variable | None,
) -> Finding:
    there = note(chosen[0], f"names {chosen[1]}")
    start = [note(process.program, f"{unit.name} starts it here")] if step.script else []
    if named and named.text == chosen[1] and step.script:
        return finding(
            named.value,
            f"ROS_DISTRO says {chosen[1]}, but {step.script.basename}, which {unit.name} starts, uses {distro}",
            advice="name one distribution, preferably through ${ROS_DISTRO}",
            related=[note(word, f"uses {distro}"), *start],
            severity="warning",
        )
    return finding(
        word,
        f"{unit.name} uses {distro} here" + (f" while ROS_DISTRO says {chosen[1]}" if named else f" after {chosen[1]}"),
        advice="name one distribution, preferably through ${ROS_DISTRO}",
        related=[there, *start],
        severity="warning" if named else None,
    )


def paths(process: Process) -> Iterator[tuple[Step, Located]]:
    """Programs and sourced files below /opt/ros, in order; those inside `if` and the like are alternatives."""
    for step in process.steps:
        words = step.command.words
        words = words[1:2] if words and words[0] in ("source", ".", "exec") else words[:1]
        for word in words:
            if step.command.depth == 0 and DISTRO.match(word):
                yield step, word
