"""The end of a display or helper shuts the whole robot down.

## What it finds
Launch files that emit `Shutdown` when a display or helper ends (RViz, rqt, a user interface, a bridge for browsers, the
aggregator of diagnostics), and that another launch file includes which starts other nodes. Silent where an
argument has to switch the helper on, and in launch files for a simulator.

## Why it matters on a robot
Shutdown ends everything that `ros2 launch` started, not only what the included file started: somebody closes the
window, or the helper crashes, and the drivers and the controllers go with it.

## Bad
```python
# display.launch.py, which bringup.launch.py includes
Node(package='rviz2', executable='rviz2', on_exit=Shutdown())
```

## Good
```python
Node(package='rviz2', executable='rviz2')
```

## When to ignore it
When the window is the switch by which people stop the robot.

## References
- launch, `Shutdown`: "shuts down a launched system"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import shut_down_by_helpers


@rule("warning", symptoms=["process[*] was required: shutting down launched system"])
def shutdown_by_helper(robot: Robot) -> Iterator[Finding]:
    for found in shut_down_by_helpers(robot.launch):
        helper, ended = found.helper.label(), found.others[0].label()
        more = f" and {len(found.others) - 1} more" if len(found.others) > 1 else ""
        yield finding(
            found.action,
            f"When {helper} ends, everything that is launched with it ends: {ended}{more}",
            advice=f"remove the shutdown, or start {helper} by itself",
            related=[
                note(found.include, "included here"),
                note(found.helper.span, f"{helper} is started here"),
                *(note(each.span, f"ends {each.label()}") for each in found.others[:3]),
            ],
            chain=robot.provenance.chain_to_node(found.helper),
        )
