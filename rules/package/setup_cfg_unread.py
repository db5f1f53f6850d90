"""A setup.cfg has lines that setuptools refuses, or that it does not read as they are meant.

## What it finds
In packages of the type `ament_python`: options that a command of setuptools does not have (`script_di` in
`[develop]`), sections whose name is nearly that of a command (`[instal]`), folders for programs that are those of
another package of the tree or nearly that of the package, and an interpreter in `[build_scripts]` that is nearly
Python.

## Why it matters on a robot
setuptools ends with "error: command 'install' has no such option", and colcon does not build the package. It says
nothing of a section that it does not know: the programs go to `bin`, and `ros2 run` and launch files, which look into
`lib/<package>`, end with "executable not found on the libexec directory". `[develop]` counts for
`colcon build --symlink-install`, `[install]` for all other builds.

## Bad
```ini
[deveop]
script_dir=$base/lib/rover_arm
```

## Good
```ini
[develop]
script_dir=$base/lib/rover_arm
```

## When to ignore it
When a plugin of setuptools defines the command.

## References
- setuptools, `Distribution._set_command_options` (65.5, tried)
- colcon-core, `task/python/build.py`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.packages import UnreadSetting

BUILDS = {"develop": "colcon build --symlink-install"}
"""The builds for which a command counts; all others for any but these."""
PROGRAMS = ("develop", "install")


@rule("error", symptoms=["has no such option", "not found on the libexec directory", "No executable found"])
def setup_cfg_unread(robot: Robot) -> Iterator[Finding]:
    for each in robot.dependencies.unread_settings:
        yield finding(
            each.where,
            _effect(each),
            advice=f"write {each.meant}" if each.meant else "remove the line",
            severity="warning" if each.kind == "section" and each.meant not in PROGRAMS else None,
        )


def _effect(each: UnreadSetting) -> str:
    section = each.meant if each.kind == "section" else each.section
    build = BUILDS.get(section, "colcon build")
    if each.kind == "option":
        return f"setuptools has no option {each.where} in [{section}]: {build} of {each.package} fails"
    if each.kind == "interpreter":
        return f"The programs of {each.package} are started with {each.where}, which does not exist: none starts"
    lost = f"ros2 run and launch files find no program of {each.package}"
    if each.kind == "folder":
        return f"{build} puts the programs into {each.where} instead of lib/{each.package}: {lost}"
    if section in PROGRAMS:
        return f"setuptools does not know [{each.where}]: {build} puts the programs into bin, and {lost}"
    return f"setuptools does not know [{each.where}]: the section has no effect"
