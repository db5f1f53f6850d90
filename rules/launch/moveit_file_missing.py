"""MoveItConfigsBuilder opens a file that its package does not have.

## What it finds
Chains of calls that begin with `MoveItConfigsBuilder("robot", package_name="package")` in Python launch files, where
the package is in the workspace and lacks a file that the calls open, or does not install it: those that the calls name
(`.robot_description_semantic(file_path="config/robot.srdf")`, `.joint_limits(...)`, `.trajectory_execution(...)`, ...),
and those that `to_moveit_configs()` opens by itself: the SRDF of `.setup_assistant` (else `config/<robot>.srdf`),
`config/kinematics.yaml` and `config/joint_limits.yaml`.

## Why it matters on a robot
The builder raises an exception while the launch file is evaluated: nothing of it starts. It happens after a robot or a
package was renamed, and with files that the setup assistant wrote only on one computer.

## Bad
```python
MoveItConfigsBuilder("arm", package_name="arm_moveit").joint_limits("config/limits.yaml").to_moveit_configs()
```

## Good
```python
MoveItConfigsBuilder("arm", package_name="arm_moveit").joint_limits("config/joint_limits.yaml").to_moveit_configs()
```

## When to ignore it
When something that the linter does not see writes the file before the build.

## References
- moveit2, moveit_configs_utils/moveit_configs_builder.py
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest

ENDINGS = (".yaml", ".srdf", ".xacro")


@rule(
    "error",
    symptoms=["ParameterBuilderFileNotFoundError", "config/*.srdf doesn't exist", "kinematics.yaml doesn't exist"],
)
def moveit_file_missing(robot: Robot) -> Iterator[Finding]:
    for each, *others in robot.plugins.missing_moveit_files:
        names = robot.tree.names_below(each.package.folder, depth=4)
        known = sorted({os.path.basename(name) for name in names if name.endswith(ENDINGS)})
        near = nearest(os.path.basename(each.path), known, 4)
        is_other = each.path.endswith(".srdf") and not any(name.endswith(".srdf") for name in known)
        homes = homes_of(robot, each.path) if is_other else []
        what = "exists in the source and is not installed" if each.exists else "does not exist"
        yield finding(
            each.where,
            f"{each.path} {what} in {each.package.name}: MoveItConfigsBuilder raises an exception, and launch aborts",
            advice="install it"
            if each.exists
            else f'write package_name="{homes[0]}", which has this file'
            if len(homes) == 1
            else f"use {launch.path_of(robot.launch, near[0], each.package)}"
            if len(near) == 1
            else "correct the path, or add it",
            related=[
                note(each.package.place, f"the package {each.package.name}"),
                *(note(other.where, f"{other.path} is missing, too") for other in others),
            ],
        )


def homes_of(robot: Robot, path: str) -> list[str]:
    """The packages of the workspace that have a file at this place."""
    packages = robot.launch.workspace.packages.values()
    places = {os.path.normpath(name) for name in robot.tree.named(os.path.basename(path))}
    return [each.name for each in packages if os.path.normpath(os.path.join(each.folder, path)) in places]
