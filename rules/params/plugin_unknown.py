"""A plugin is named as no package exports it.

## What it finds
`plugin:` and `type:` in parameter files, and `<plugin>` in the `<ros2_control>` of robot descriptions, when

- the name belongs to a package of the tree, whose plugin descriptions hold no such class, or
- the package of Navigation2, ros2_controllers or ros2_control exports the class under another name in the distribution
  of the robot, or under nearly the same: `nav2_recoveries/Spin` became `nav2_behaviors/Spin` (Humble) and
  `nav2_behaviors::Spin` (Jazzy), `fake_components` became `mock_components`. A distribution in the path of the file
  counts more. Where the tree names several, the name must be missing in each of them, and where none is known, in all
  that there are, or
- no file of the tree but parameter files names the package, so that nothing builds, fetches or installs it: a warning.
  The namespace is taken for the name of the package, and simulators do not count.

Sections that are switched off, or that no list of plugins of their node has (nor the default of a list that is not
written), count as a file that nothing loads.

## Why it matters on a robot
pluginlib compares names letter by letter. A server of Navigation2 ends when it configures, and the lifecycle manager
takes the whole stack down. ros2_control does not load the hardware, and no controller ever starts.

## Bad
```yaml
behavior_server:
  ros__parameters:
    spin:
      plugin: nav2_behaviors/Spin     # Jazzy
```

## Good
```yaml
behavior_server:
  ros__parameters:
    spin:
      plugin: nav2_behaviors::Spin
```

## When to ignore it
When the file is kept for an older distribution, or the build writes the plugin description.

## References
- https://docs.nav2.org/migration/ (Iron to Jazzy: all plugins are named with `::`)
- pluginlib, `ClassLoader::createUniqueInstance`
- the plugin descriptions of navigation2, ros2_controllers and ros2_control, branch by branch
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import UnknownPlugin
from bringup_lint.api.spelling import nearest


@rule(
    "error",
    symptoms=[
        "According to the loaded plugin descriptions the class * with base class type * does not exist",
        "Failed to create plugin of type",
        "Failed to create global planner. Exception:",
        "Failed to create controller. Exception:",
        "Failed to load hardware '*' from plugin",
        "Loader for controller '*' (type '*') not found.",
        "Failed to create *, is it registered and built? Exception:",
    ],
)
def plugin_unknown(robot: Robot) -> Iterator[Finding]:
    found: dict[tuple[str, str], list[UnknownPlugin]] = {}
    for each in robot.plugins.unknown:
        found.setdefault(_cause(each), []).append(each)
    for first, *others in found.values():
        if first.unbrought:
            yield _unbrought(first, others)
            continue
        where = f" in {first.distribution.capitalize()}" if first.distribution else ""
        more = (
            f", nor {'are' if len(others) > 1 else 'is'} {len(others)} other{'s' * (len(others) > 1)}" if others else ""
        )
        yield finding(
            first.name,
            f"No plugin is called {first.name}{where}: it is not loaded{more}",
            advice=f"write {first.exported}" if first.exported else "write the name of the plugin description",
            severity=_severity(robot, first),
            related=[*_exported(first), *(note(each.name, "here, too") for each in others[:10])],
        )


def _cause(plugin: UnknownPlugin) -> tuple[str, str]:
    """What several findings have in common: a missing package, a name, or the distribution of a file."""
    if plugin.unbrought:
        return "", plugin.package
    is_description = plugin.name.span.source.kind == "urdf" or plugin.distribution is None
    return ("", str(plugin.name)) if is_description else (plugin.name.span.path, "")


def _unbrought(plugin: UnknownPlugin, others: list[UnknownPlugin]) -> Finding:
    declare = f"add <exec_depend>{plugin.package}</exec_depend> to the package.xml, or the repository that has it"
    return finding(
        plugin.name,
        f"Nothing of this tree declares, builds or fetches a package {plugin.package}: {plugin.name} is not loaded",
        advice=f"write {plugin.exported}, or add the repository that has it" if plugin.exported else declare,
        severity="warning",
        related=[note(each.name, "here, too") for each in others[:10]],
    )


def _severity(robot: Robot, plugin: UnknownPlugin) -> str:
    """Warning for hardware that only stands in for the real one, info for what nothing loads, and for packages
    that the images of the tree leave out: these may be built with another distribution."""
    owner = robot.launch.workspace.owner(plugin.name.span.source) if plugin.distribution else None
    if owner is not None and _is_left_out(robot, owner.name):
        return "info"
    stands_in = plugin.package in ("fake_components", "mock_components")
    if not plugin.loaded:
        return "warning" if _is_misspelt(plugin) else "info"
    return "warning" if stands_in else "error"


def _is_misspelt(plugin: UnknownPlugin) -> bool:
    """Whether the name is a letter away from the one that is meant, and so no release has it."""
    return bool(plugin.exported) and bool(nearest(plugin.name, [str(plugin.exported)], 1))


def _is_left_out(robot: Robot, package: str) -> bool:
    """Whether an image of the tree is built without a package."""
    name = re.escape(package)
    ignored = re.compile(
        rf"(?<![\w-]){name}/COLCON_IGNORE\b|--packages-(?:skip|ignore)[ \t][^\n]*(?<![\w-]){name}(?![\w-])"
    )
    return any(package in each.text and ignored.search(each.text) for each in robot.of_kind("dockerfile"))


def _exported(plugin: UnknownPlugin) -> list[Related]:
    name = plugin.exported
    return [note(name, "this name is exported")] if isinstance(name, Located) else []
