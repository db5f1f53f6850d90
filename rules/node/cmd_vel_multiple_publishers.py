"""Several nodes publish the velocity command.

## What it finds
Two or more nodes that run together and publish the same velocity topic (`cmd_vel`, `base_cmd_vel`, ...), when no
multiplexer, gate, smoother or collision monitor is among them. If a node of this tree limits velocities, publishers
that bypass it are also reported. So is what publishes the topic to which twist_mux sends what it has chosen. The same
for a collision monitor of Nav2 whose `cmd_vel_out_topic` is a topic to which servers of Nav2 publish by themselves,
which is an error. Nodes that an argument must enable, or that exclude each other, do not count. The servers of Nav2
take turns and count as one.

## Why it matters on a robot
The base obeys the message that arrived last. A stop from one node is followed milliseconds later by the next
command of the other.

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

## When to ignore it
When the nodes coordinate themselves so that only one publishes at a time, for example through a service or a
lifecycle state.

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


@rule("warning", confidence="medium", silent="several publishers of one topic are normal for ROS", tags=["CWE-362"])
def cmd_vel_multiple_publishers(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for running in robot.topics.runs:
        if running.simulated:
            continue
        for rivals in topics.rivals(running):
            places = frozenset(use.where for use in rivals)
            if places in seen:
                continue
            seen.add(places)
            own = next((use for use in reversed(rivals) if not use.of_table), rivals[-1])
            others = [use for use in rivals if use is not own]
            names = ", ".join(use.node.label() for use in (*others, own))
            yield finding(
                own.where,
                f"{len(rivals)} nodes publish {own.topic} ({names}) and nothing selects one: a stop of one is followed "
                "by a go of another",
                advice="give each source its own topic, and let twist_mux or another gate publish the command",
                related=[
                    *(note(use.where, f"{use.node.label()} publishes it too") for use in others),
                    *(note(use.node.started.span, f"{use.node.label()} is started here") for use in rivals),
                ],
            )
    yield from past_the_mux(robot)
    yield from past_the_monitor(robot)


def past_the_mux(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for running in robot.topics.runs:
        for mux, *others in topics.past_the_mux(running):
            places = frozenset(use.where for use in others)
            if running.simulated or places in seen:
                continue
            seen.add(places)
            names = " and ".join(use.node.label() for use in others)
            yield finding(
                others[0].where,
                f"{names} publish{'es' * (len(others) < 2)} {mux.topic}, to which {mux.node.label()} sends what it has "
                "chosen: no priority and no lock holds that back",
                advice=f"remap it to an input of {mux.node.label()}",
                related=[
                    *(note(use.where, f"{use.node.label()} publishes it too") for use in others[1:]),
                    note(mux.node.started.span, "the multiplexer"),
                ],
            )


def past_the_monitor(robot: Robot) -> Iterator[Finding]:
    seen = set()
    for running in robot.topics.runs:
        for each in topics.unmonitored(robot.topics, running):
            if each.where in seen:
                continue
            seen.add(each.where)
            names = " and ".join(dict.fromkeys(use.node.label() for use in each.past))
            yield finding(
                each.where,
                f"The collision monitor sends to {each.topic}, to which {names} publish{'es' * (len(each.past) < 2)} "
                "directly: whoever listens there obeys what the monitor never sees",
                advice="give the monitor their topic as cmd_vel_in_topic, and what drives the base the monitor's own",
                related=[
                    *(note(use.where, f"{use.node.label()} publishes to {each.topic}") for use in each.past),
                    note(each.monitor.started.span, "the monitor is started here"),
                ],
                chain=robot.provenance.chain_to_node(each.monitor.started),
                severity="error",
            )
