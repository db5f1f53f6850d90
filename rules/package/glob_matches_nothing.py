"""A glob of a setup.py matches no file, and the files beside it are not installed.

## What it finds
`glob(...)` in data_files of a setup.py that matches no file of its folder, where the folder has files that nothing else
installs, or where the folder itself has nearly another name. What a launch file of the tree opens is left to
`launch/file-not-installed`.

## Why it matters on a robot
A glob without a match is an empty list: the build succeeds, and the share folder of the package lacks the folder on
the robot. Whatever looks for a file there ends with an exception, or goes on with its defaults.

## Bad
```python
(os.path.join('share', package_name, 'params'), glob('params/*.yml')),   # the file is params/drive.yaml
```

## Good
```python
(os.path.join('share', package_name, 'params'), glob('params/*.yaml')),
```

## When to ignore it
When the files of the folder are only for the workstation.

## References
- Python, `glob.glob`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="a glob without a match is an empty list, and setuptools installs nothing")
def glob_matches_nothing(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        idle = list(robot.dependencies.idle_globs(package)) if robot.dependencies.judged(package) else []
        for each in idle:
            first, *others = each.files
            more = f" and {len(others)} more are" if others else " is"
            path = f"{each.folder}/{first}"
            yield finding(
                each.install.where,
                f"{each.install.source} matches no file: {path}{more} not installed",
                advice="write the folder and the ending of the files, or remove the entry",
                related=[note(package.place, f"nothing else of {package.name} installs them")],
            )
