"""A Python package has another version in setup.py than in package.xml.

## What it finds
`version` of `setup()`, written as a plain text, that is not the `<version>` of the package.xml beside it, in a package
of the type `ament_python`.

## Why it matters on a robot
ROS knows the package by the one version, and Python by the other: `ros2 pkg xml` and the Debian package say 1.2.0 where
`pip list` and `importlib.metadata.version()` say 0.0.0. Who looks up what a robot runs is told the wrong one.

## Bad
```python
setup(name="rover_arm", version="0.0.0")  # package.xml: <version>1.2.0</version>
```

## Good
```python
setup(name="rover_arm", version="1.2.0")
```

## When to ignore it
When nobody releases the package, and nothing asks for its version.

## References
- REP 149, "version"
- catkin_prepare_release and bloom, which write the version to both files
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("info", silent="colcon and setuptools compare the two with each other nowhere")
def version_differs(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        is_python = package.manifest.build_type == "ament_python" and robot.dependencies.must_declare(package)
        found = robot.dependencies.differing_version(package) if is_python else None
        if found is not None:
            of_setup, declared = found
            yield finding(
                of_setup,
                f"Python knows {package.name} as version {of_setup}, and ROS as {declared}: one of them is wrong",
                advice="write the same version in both files",
                related=[note(declared, "the version of package.xml")],
            )
