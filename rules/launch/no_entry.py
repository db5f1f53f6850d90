"""A launch file has no entry function.

## What it finds
A `*.launch.py` file without `generate_launch_description()`. A file that holds nothing but comments is left out.

## Why it matters on a robot
`ros2 launch` imports the file, does not find the function and exits with an error. Nothing starts.

## Bad
```python
def generate_description():
    return LaunchDescription([Node(package='demo', executable='talker')])
```

## Good
```python
def generate_launch_description():
    return LaunchDescription([Node(package='demo', executable='talker')])
```

## When to ignore it
When the file holds only functions that other launch files import. A name without `.launch.py` says so, and removes
the finding.

## References
- launch, `get_launch_description_from_python_launch_file`
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

STATEMENT = regex(r"^[ \t]*[^#\s]", re.M)


@rule(
    "error",
    symptoms=[
        "has no attribute 'generate_launch_description'",
        "does not contain the required function 'generate_launch_description()'",
    ],
)
def no_entry(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if file.format != "python" or file.entry is not None or file.problems:
            continue
        if file.source.name.endswith(".launch.py") and STATEMENT.search(file.source.text):
            yield finding(
                file.source,
                "There is no generate_launch_description(): ros2 launch rejects the file",
                advice="define generate_launch_description() and return a LaunchDescription from it",
            )
