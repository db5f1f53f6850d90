"""systemd stops ros2 launch with a signal that makes it abandon its nodes.

## What it finds
A service that runs ros2 launch and is stopped with a signal other than SIGINT: KillSignal= is not set
(SIGTERM) or names another signal. One-shot services and containers are exempt. Info where `KillMode=control-group`
stops the nodes as well, and none of the tree waits for SIGINT alone, or the only one drives and records nothing.

An `ExecStop=kill -INT $MAINPID` does not help: systemd sends the other signal as soon as that command has returned. One
that waits for the end does, and is not reported.

## Why it matters on a robot
On SIGINT, ros2 launch runs its shutdown handlers and stops its nodes: SIGINT, then SIGTERM, then SIGKILL. On
SIGTERM it exits at once. With the default KillMode= the nodes get the same signal and end by themselves in any order;
with others they are killed without reaching their safe state, or keep running.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
```

## Good
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
KillSignal=SIGINT
TimeoutStopSec=20
```

## When to ignore it
When every node handles SIGTERM, and the order of their ends does not matter.

## References
- systemd.kill(5), KillSignal=
- <https://github.com/ros2/launch/issues/666>
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.systemd import Process
from bringup_lint.api.systemd import Unit

SIGINT = ("-INT", "-SIGINT", "-2", "--signal=SIGINT", "--signal=INT", "-sINT")
WAITS = regex(r"\btail\b|\bwhile\b|\buntil\b|\bsleep\b|\bwait(?:pid)?\b")
DRIVES = regex(r"(?i:cmd_vel|motor|wheel|servo|joint|thruster|rosbag|record)")
THEN = {
    "mixed": "ros2 launch exits without stopping its nodes, and systemd kills them with SIGKILL",
    "process": "ros2 launch exits without stopping its nodes, and they keep running",
    "none": "ros2 launch exits without stopping its nodes, and they keep running",
}


@rule(
    "warning",
    fix="unsafe",
    symptoms=["State 'stop-sigterm' timed out. Killing.", "using SIGTERM or SIGQUIT can result in orphaned processes"],
)
def kill_signal_not_sigint(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        service = robot.units.supervision(unit)
        launches = robot.units.launches(unit)
        signal = service.kill_signal
        if not launches or not unit.complete or signal.value in ("SIGINT", None) or unit.get("Type") == "oneshot":
            continue
        if service.in_container or (signal.at is None and unit.get("KillSignal")):
            continue
        mode = service.kill_mode.value or "control-group"
        needy = list(waiting_for_sigint(robot, unit))
        stop = _interrupting(robot, unit)
        if stop is not None and any(WAITS.search(text) for text in stop.texts):
            continue
        change = (signal.at, "SIGINT") if signal.at else unit.new_line("Service", "KillSignal=SIGINT")
        yield finding(
            signal.at or unit.where,
            message(unit.name, str(signal.value), mode)
            if stop is None
            else _at_once(unit.name, str(signal.value), mode),
            advice="set KillSignal=SIGINT",
            related=[
                *(note(found.where, "the unit starts ros2 launch here") for found in launches),
                *(note(each.program, "returns at once") for each in [stop] if each is not None),
                *(note(place, "ends with a traceback: it waits for Ctrl-C, which is SIGINT") for place in needy[:5]),
            ],
            severity=None if mode != "control-group" or (needy and not _is_idle(robot, unit, needy)) else "info",
            fix=fix("set KillSignal=SIGINT", change) if unit.editable else None,
        )


def message(unit: str, signal: str, mode: str) -> str:
    if mode in THEN:
        return f"systemd stops {unit} with {signal}: {THEN[mode]}"
    return (
        f"systemd sends {signal} to ros2 launch and all nodes of {unit} at once: nothing is stopped in order, and "
        "ros2 launch does not wait for its nodes"
    )


def _at_once(unit: str, signal: str, mode: str) -> str:
    then = THEN.get(mode, "ros2 launch does not wait for its nodes any more")
    return f"ExecStop= of {unit} sends SIGINT and returns, so that systemd sends {signal} at the same time: {then}"


def _interrupting(robot: Robot, unit: Unit) -> Process | None:
    """The ExecStop= that sends SIGINT."""
    for process in robot.units.processes(unit):
        if process.key == "ExecStop" and any(word in SIGINT for step in process.steps for word in step.command.words):
            return process
    return None


def _is_idle(robot: Robot, unit: Unit, needy: list[Span]) -> bool:
    """Whether a unit launches one node alone, and one that drives and records nothing."""
    found = [robot.runners.expansion(each.start) for each in robot.runners.launches if each.runner.unit is unit]
    nodes = [node for each in found if each is not None for node in each.nodes]
    known = all(each is not None and not each.open for each in found)
    return known and len(nodes) == 1 and not any(DRIVES.search(span.source.text) for span in needy)


def waiting_for_sigint(robot: Robot, unit: Unit) -> Iterator[Span]:
    """Where the programs that a unit launches handle SIGINT alone."""
    if not robot.of_kind("python-node"):
        return
    for file in robot.nodes.robot_sources:
        if any(runner.unit is unit for runner in nodes.runners_of(robot.nodes, file)):
            yield from (file.span_of(caught) for caught, _ in nodes.unhandled_shutdown(robot.nodes.ending(file)))
