"""The address of a camera calibration is none that camera_info_manager understands.

## What it finds
`camera_info_url` in parameter files that something uses and in launch files, when it does not begin with `file:///` or
`package://PACKAGE/`: a plain path, a path after two slashes, or the path of a file in the share folder of a package.
Silent for nodes of the tree whose package does not depend on camera_info_manager.

## Why it matters on a robot
The driver prints an error and goes on without the calibration. Every CameraInfo is empty: rectification, AprilTags and
depth give nothing or wrong distances.

## Bad
```python
parameters=[{'camera_info_url': os.path.join(share, 'config', 'camera.yaml')}]
```

## Good
```python
parameters=[{'camera_info_url': 'file://' + os.path.join(share, 'config', 'camera.yaml')}]
```

## When to ignore it
When the driver reads the file itself.

## References
- camera_info_manager, camera_info_manager.cpp (`parse_url`, `load_calibration`)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.params import refused_urls


@rule("error", symptoms=["Invalid camera calibration URL: *"])
def camera_info_url(robot: Robot) -> Iterator[Finding]:
    for each in refused_urls(robot.launch, robot.params):
        yield finding(
            each.where,
            f"camera_info_url is {each.given}, which is not an address: the camera stays uncalibrated",
            advice=f"write {each.instead}",
            related=[note(other, "here, too") for other in each.others],
        )
