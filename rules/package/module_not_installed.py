"""A node imports a module of its package that the build does not install.

## What it finds
Console scripts and modules of an ament_python package that need a folder of modules beside them, which `packages` of
setup.py does not install: it lists the outer package only, or `find_packages` passes over a folder without an
`__init__.py`. Imports inside `try`, `if` and functions are not judged. It is an info when something of the tree
builds with `--symlink-install`, which leads to the source and hides the mistake, and a warning when no console script
names the module that imports it.
Also scripts that CMakeLists.txt installs as programs and that import a module from their own folder, which it does not
install there.

## Why it matters on a robot
The node works where the workspace is built with `--symlink-install`, and ends with "No module named" on a robot that
has the installed tree, a container or a Debian package.

## Bad
```python
packages=['arm_driver'],   # arm_driver/bus/frames.py is imported by arm_driver/node.py
```

## Good
```python
packages=find_packages(exclude=['test']),   # and there is an arm_driver/bus/__init__.py
```

## When to ignore it
When the robot always runs from the source workspace.

## References
- setuptools, "Package Discovery and Namespace Packages"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.launch import Package

SYMLINKS = regex(r"--symlink-install\b")


@rule("error", symptoms=["ModuleNotFoundError: No module named"])
def module_not_installed(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        if not robot.dependencies.judged(package):
            continue
        for module, folder, listed in robot.dependencies.left_out_modules(package):
            path = folder.replace(".", "/")
            severity = None if _is_started(module.span.source, package) else "warning"
            found = listed.names is None
            yield finding(
                module,
                f"setup.py does not install {folder}: on the robot this ends with \"No module named '{folder}'\"",
                advice=f"add {path}/__init__.py" if found else f"add '{folder}' to packages, or use find_packages()",
                related=[note(listed.where, "takes folders with an __init__.py" if found else "what is installed")],
                severity="info" if robot.files.mentions(SYMLINKS) else severity,
            )
        for each in robot.dependencies.left_beside(package):
            program = each.module.span.source.basename
            yield finding(
                each.module,
                f"{each.path} is not installed beside {program}, which ends with \"No module named '{each.module}'\"",
                advice=f"add {each.path} to the files that are installed with {program}",
                related=[note(each.program.where, f"{program} is installed here")],
                severity="info" if robot.dependencies.leads_to_source(package) else None,
            )


def _is_started(module: Source, package: Package) -> bool:
    """Whether a console script is, or names, the module that imports the folder."""
    name = f"{module.basename.removesuffix('.py')}:"
    return any(build.source is module or name in build.source.text for build in package.builds)
