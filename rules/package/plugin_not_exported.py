"""A package builds a plugin and does not export its description.

## What it finds
XML files that describe classes of pluginlib in a library that the package builds, where no
`pluginlib_export_plugin_description_file` of its CMakeLists.txt names the file.

## Why it matters on a robot
pluginlib looks for plugins in the ament index only. It ends with "According to the loaded plugin descriptions the class
... with base class type ... does not exist": controller_manager loads no hardware, a Nav2 server does not configure.

## Bad
```cmake
add_library(lift_hardware SHARED src/lift.cpp)   # lift_hardware.xml describes lift_hardware/Lift
ament_package()
```

## Good
```cmake
add_library(lift_hardware SHARED src/lift.cpp)
pluginlib_export_plugin_description_file(hardware_interface lift_hardware.xml)
ament_package()
```

## When to ignore it
When the class is loaded by other means than pluginlib.

## References
- pluginlib, `pluginlib_export_plugin_description_file`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["According to the loaded plugin descriptions the class"])
def plugin_not_exported(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        if not robot.dependencies.judged(package):
            continue
        for each in robot.dependencies.unexported(package):
            base = each.base.rpartition("::")[0].partition("::")[0] or "BASE"
            copied = [note(each.copied, "this only copies the description")] if each.copied is not None else []
            yield finding(
                each.end,
                f"{package.name} does not export {each.description.basename}: pluginlib finds no class {each.name}",
                advice=f"add pluginlib_export_plugin_description_file({base} {each.path}) above",
                related=[note(each.name, "this class is described"), *copied],
            )
