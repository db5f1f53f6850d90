"""Real-time scheduling for all nodes of a launch file.

## What it finds
A service that runs ros2 launch and lets every child inherit one of these:

- CPUSchedulingPolicy=fifo or rr with a priority of 90 or above, or without a priority, unless
  CPUSchedulingResetOnFork= is set;
- IOSchedulingClass=realtime.

## Why it matters on a robot
Every node, including the loggers, then has priority over journald, sshd and the kernel's own threads. One
busy loop locks the machine. One bag recorder starves all other disk access.

## Bad
```ini
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec ros2 launch rover base.launch.py'
CPUSchedulingPolicy=fifo
CPUSchedulingPriority=95
IOSchedulingClass=realtime
```

## Good
```ini
# a unit of its own for the one node that needs it
[Service]
ExecStart=/bin/bash -c 'source /opt/ros/jazzy/setup.bash && exec /opt/ros/jazzy/lib/rover/motor_loop'
CPUSchedulingPolicy=fifo
CPUSchedulingPriority=50
```

## When to ignore it
When every node of the launch file is a control loop with a bounded run time, and CPU cores are reserved for
the rest of the system.

## References
- systemd.exec(5), CPUSchedulingPolicy=, CPUSchedulingResetOnFork= and IOSchedulingClass=; sched(7)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

HIGH = 90


@rule("warning", symptoms=["sched: RT throttling activated"])
def rt_starvation(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.ros:
        launches = robot.units.launches(unit)
        if not launches or not unit.complete:
            continue
        tree = [note(found.where, "every node of this launch inherits it") for found in launches]
        policy, priority = unit.get("CPUSchedulingPolicy"), unit.get("CPUSchedulingPriority")
        inherited = not unit.flag("CPUSchedulingResetOnFork")
        if (
            policy in ("fifo", "rr")
            and inherited
            and (priority is None or (priority.isdecimal() and int(priority) >= HIGH))
        ):
            level = f"priority {priority}" if priority else "no explicit priority"
            yield finding(
                priority or policy,
                f"All nodes of {unit.name} run with {policy} scheduling, {level}: a busy loop in one of "
                "them locks the machine",
                advice="give real-time scheduling to the one node that needs it, in a unit of its own",
                related=[*tree, *([note(policy, "real-time scheduling")] if priority else [])],
            )
        io = unit.get("IOSchedulingClass")
        if io in ("realtime", "1"):
            yield finding(
                io,
                f"The disk access of all nodes of {unit.name} comes first: journald, sshd and the rest can starve",
                advice="remove the line, or set the class only for the one service that needs it",
                related=tree,
            )
