"""Several nodes that command the same wheels.

## What it finds
Two or more nodes that run together and publish one velocity topic (`cmd_vel`, `base_cmd_vel`, ...), under its full name
and with nothing between them that chooses: no multiplexer, gate, smoother or collision monitor is among the publishers.
Where a node of the tree limits velocities, also those who publish past it. Nodes that an argument has to switch on, or
that exclude each other, do not count, and the servers of Nav2, which take turns, count as one.

## Why it matters on a robot
The base obeys whatever arrived last. A stop from one node is followed by the next command of the other, some
milliseconds later.

## Bad
```python
Node(package="mower", executable="follow_wire"),   # publishes cmd_vel
Node(package="teleop_twist_joy", executable="teleop_node"),   # and so does this
```

## Good
```python
Node(package="mower", executable="follow_wire", remappings=[("cmd_vel", "cmd_vel_wire")]),
Node(package="teleop_twist_joy", executable="teleop_node", remappings=[("cmd_vel", "cmd_vel_joy")]),
Node(package="twist_mux", executable="twist_mux", remappings=[("cmd_vel_out", "cmd_vel")], parameters=[inputs]),
```

## References
- twist_mux
- Nav2, collision monitor and velocity smoother
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics


@rule("error", confidence="medium", tags=["CWE-362"])
def cmd_vel_multiple_publishers(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for running in robot.topics.runs:
        for rivals in topics.rivals(running) if not running.simulated else ():
            places = frozenset((id(use.where.source), use.where.start) for use in rivals)
            if places in seen:
                continue
            seen.add(places)
            own = next((use for use in reversed(rivals) if not use.of_table), rivals[-1])
            others = [use for use in rivals if use is not own]
            names = ", ".join(use.node.label() for use in (*others, own))
            yield finding(
                own.where,
                f"{names} publish {own.topic} and nothing chooses between them: a stop of one is followed by a go "
                "of another",
                advice="give each source a topic of its own, and let twist_mux or another gate publish the command",
                related=[
                    *(note(use.where, f"{use.node.label()} publishes it too") for use in others),
                    *(note(use.node.started.span, f"{use.node.label()} is started here") for use in rivals),
                ],
            )
