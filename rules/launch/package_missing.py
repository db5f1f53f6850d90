"""A launch file starts a node from a package that does not exist.

## What it finds
A name that no package of this workspace has, but that is close to one that exists.

## Why it matters on a robot
launch aborts with "package 'my_robot_drivers' not found".

## Bad
```python
Node(package='my_robot_drivers', executable='motor')   # the package is called my_robot_driver
```

## Good
```python
Node(package='my_robot_driver', executable='motor')
```

## When to ignore it
When both packages exist, and the other one is not in this repository.

## References
- ament_index, `get_package_prefix`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error", fix="unsafe", symptoms=["PackageNotFoundError", "not found, searching", "package '*' not found, searching"]
)
def package_missing(robot: Robot) -> Iterator[Finding]:
    workspace = robot.launch.workspace
    for node in robot.launch.nodes:
        package = launch.literal_text(node.package)
        owner = workspace.owner(node.file.source)
        if package is None or owner is None or package == owner.name or owner.depends_on(package):
            continue
        near = robot.launch.meant(package)
        if near is not None:
            yield finding(
                package,
                f"Package '{package}' not found: launch aborts",
                advice=f"start it from '{near.name}'",
                chain=robot.provenance.chain_to_node(node),
                related=[note(near.place, "the package of the workspace")],
                fix=fix(f"write {near.name}", (package, near.name), safe=False)
                if package.span.text == package
                else None,
            )
