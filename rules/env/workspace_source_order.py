"""The workspace is sourced before the distribution.

## What it finds
A shell that sources the setup file of a workspace first and `/opt/ros/<distro>/setup.*` after it, in a unit or in a
script of the tree that a unit starts.

## Why it matters on a robot
Each setup file puts its own paths first. If the distribution is sourced last, it hides every package of which the
workspace has a modified copy: the robot silently runs the released navigation stack instead of the patched one.

## Bad
```bash
source /opt/rover/install/setup.bash
source /opt/ros/jazzy/setup.bash
```

## Good
```bash
source /opt/ros/jazzy/setup.bash
source /opt/rover/install/setup.bash
```

## When to ignore it
When the workspace has no package that also exists in the distribution. The order is still fragile.

## References
- ROS 2 documentation, "Creating a workspace": overlay and underlay
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def workspace_source_order(robot: Robot) -> Iterator[Finding]:
    for unit in robot.units.services:
        for process in robot.units.processes(unit):
            workspace = None
            for step, word in process.setup_files:
                if not word.startswith("/opt/ros/"):
                    workspace = workspace or (step, word)
                elif workspace and step.command.depth == 0 and workspace[0].command.depth == 0:
                    yield finding(
                        word,
                        f"{word} is sourced last and hides the packages of {workspace[1]} that exist in both",
                        advice="source the distribution first, then the workspace",
                        related=[
                            note(workspace[1], "the workspace is sourced here"),
                            *(note(process.program, f"{unit.name} starts it here") for _ in [0] if step.script),
                        ],
                    )
                    break
