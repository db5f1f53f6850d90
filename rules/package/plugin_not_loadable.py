"""The description of a plugin does not agree with what the package builds.

## What it finds
Descriptions of pluginlib that name a library which the package does not build, or one that does not hold the class;
classes that no source exports with `PLUGINLIB_EXPORT_CLASS` under this name, or whose source is in no library; and
descriptions that are exported for another package than the one under whose name the plugins are looked for. Classes
that are exported by macros of one's own, and libraries whose sources are computed, are not judged. What no
other file of the tree names is a warning, and information where no source has the class.

## Why it matters on a robot
The build succeeds. pluginlib finds the description and not the class: controller_manager loads no hardware and no
controller, a server of Nav2 does not configure, a node ends with an exception when it asks for the plugin.

## Bad
```xml
<library path="lift_plugins">   <!-- CMakeLists.txt: add_library(lift_hardware SHARED src/lift.cpp) -->
```

## Good
```xml
<library path="lift_hardware">
```

## When to ignore it
When a step after the build puts the library where pluginlib looks.

## References
- pluginlib, `ClassLoader::createInstance`, `pluginlib_export_plugin_description_file`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "Could not find library corresponding to plugin",
        "Failed to load library",
        "MultiLibraryClassLoader: Could not create object of class type",
    ],
)
def plugin_not_loadable(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        if not robot.dependencies.judged(package):
            continue
        for each in robot.dependencies.unloadable(package):
            message, advice, said = _words(each.kind, str(each.name), each.written, each.meant)
            yield finding(
                each.where,
                message,
                advice=advice,
                related=[note(each.related, said)] if each.related is not None else [],
                severity=None if each.is_named else _of_unnamed(each.kind),
            )


def _of_unnamed(kind: str) -> str:
    """A description without a class is left over where nothing names it; a class without a description is not."""
    return "info" if kind == "class" else "warning"


def _words(kind: str, name: str, where: str, meant: str) -> tuple[str, str, str]:
    if kind == "category":
        return (
            f"pluginlib looks for {name} among the plugins of {meant}, and does not find it among those of {where}",
            f"write pluginlib_export_plugin_description_file({meant} ...)",
            "plugins of this package are looked for",
        )
    if kind == "class":
        return (
            f"No source exports a class {where}: pluginlib cannot create {name}",
            f'write type="{meant}"' if meant else "name the class as PLUGINLIB_EXPORT_CLASS does",
            "this class is exported",
        )
    if kind == "source":
        return (
            f"The source of {where} is in no library: pluginlib cannot create {name}",
            f"add it to add_library({meant} ...)",
            "exported here",
        )
    return (
        f"pluginlib does not find {name} in lib{where}.so: it is built into lib{meant}.so",
        f'write path="{meant}"',
        "this library has the class",
    )
