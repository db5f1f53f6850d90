"""A node opens a file beside its module that setup.py does not install.

## What it finds
Files and folders of an ament_python package that the modules of its console scripts name by their own place, with
`__file__` or as templates of Flask, and that the build leaves in the source: setuptools installs modules alone, and
what `data_files` takes goes to `share`. Silent where `package_data`, `include_package_data` or anything else may bring
them, where the module asks first whether they are there, inside of `try`, and for the default of a parameter, an option
or a variable that something of the tree sets. It is an info where the tree builds with
`--symlink-install`, which leads to the source and hides the mistake, and no script or image builds without.

## Why it matters on a robot
The node works where the workspace is built with `--symlink-install`, and ends with FileNotFoundError on a robot that
has the installed tree, a container or a Debian package.

## Bad
```python
LABELS = os.path.join(os.path.dirname(__file__), '..', 'models', 'labels.txt')
```

## Good
```python
LABELS = os.path.join(get_package_share_directory('gate_vision'), 'models', 'labels.txt')
```

## When to ignore it
When the robot always runs from the source workspace.

## References
- setuptools, "Data Files Support"
- https://docs.ros.org/en/jazzy/How-To-Guides/Developing-a-ROS-2-Package.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "warning",
    symptoms=[
        "FileNotFoundError: [Errno 2] No such file or directory: '*/site-packages/*'",
        "jinja2.exceptions.TemplateNotFound:",
    ],
)
def data_not_installed(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        if not robot.dependencies.judged(package):
            continue
        found = list(robot.dependencies.data_beside(package))
        if found:
            first, *others = found
            more = f", and {len(others)} more" if others else ""
            yield finding(
                first.where,
                f"The build does not install {first.path} where the module looks for it{more}: the installed node ends",
                advice=f"install it with data_files, and look for it in get_package_share_directory('{package.name}')",
                related=[
                    *(note(each.where, f"{each.path} is named here") for each in others),
                    note(first.installed.where, "only the modules of these are installed there"),
                ],
                severity="info" if robot.dependencies.leads_to_source(package) else None,
            )
