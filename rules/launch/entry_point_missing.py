"""A console script names a module or function that the package does not have.

## What it finds
Entries of `console_scripts` in setup.py or setup.cfg whose module is not in the package, or whose function the module
does not define or import, and entries without a colon between the module and the function, unless the module itself
does the work when it is imported. Where `find_packages` finds only other folders than the one called like the package,
its scripts are found, too. Packages of other names, modules that git ignores, compiled modules and modules with
`from x import *` are not judged. A script that nothing starts is a warning.

## Why it matters on a robot
The build succeeds and installs the executable. It ends at its start with `ModuleNotFoundError` or `ImportError`, and so
does every restart.

## Bad
```python
'controller_node = my_robot.controler:main'   # the file is my_robot/controller.py
```

## Good
```python
'controller_node = my_robot.controller:main'
```

## When to ignore it
When a step before the build writes the module.

## References
- Python Packaging User Guide, "Entry points specification"
"""

import os
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import MissingEntry
from bringup_lint.api.launch import literal_text
from bringup_lint.api.launch import missing_entries


@rule(
    "error",
    symptoms=[
        "ModuleNotFoundError: No module named",
        "cannot import name",
        "AttributeError: module '*' has no attribute 'main'",
    ],
)
def entry_point_missing(robot: Robot) -> Iterator[Finding]:
    workspace = robot.launch.workspace
    started = {(literal_text(node.package), literal_text(node.executable)) for node in robot.launch.nodes}
    started |= {(ros.package, ros.target) for _, ros in robot.runners.run}
    for package in workspace.packages.values():
        for entry in missing_entries(robot.tree, package):
            if not entry.script.span.source.judged:
                continue
            runs = (package.name, str(entry.script)) in started
            yield finding(
                entry.script,
                f"`ros2 run {package.name} {entry.script}` fails with {_lack(entry)}",
                advice=_advice(entry),
                related=[note(entry.file.whole, "the module")] if entry.file else [],
                severity=None if runs else "warning",
            )


def _lack(entry: MissingEntry) -> str:
    if ":" not in entry.package.entry_points[str(entry.script)]:
        return f"an exception: {entry.module} is taken for a module, a colon names the function in it"
    if entry.file is None:
        return f"ModuleNotFoundError: {entry.package.name} has no module {entry.module}"
    return f"ImportError: {os.path.basename(entry.file.name)} has no function {entry.function}"


def _advice(entry: MissingEntry) -> str:
    module, _, function = entry.module.rpartition(".")
    if ":" in entry.package.entry_points[str(entry.script)]:
        return "name the module and function that exist, or remove the script"
    return f"write {entry.module}:main" if entry.file else f"write {module}:{function}"
