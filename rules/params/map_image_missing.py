"""A map names an image that does not exist.

## What it finds
`image` in the YAML file of a map, relative to it, where the folder has no such file but another image that no map
names, or one that is called like the map. An image beside the map that is named by a path in a home folder of which
nothing else of the tree speaks is a warning. Other absolute paths, and images that git ignores, are not judged.

## Why it matters on a robot
map_server fails to configure, the lifecycle manager aborts the bring-up, and neither localization nor planning starts.

## Bad
```yaml
image: yard_2.pgm   # the file is called yard2.pgm
resolution: 0.05
```

## Good
```yaml
image: yard2.pgm
resolution: 0.05
```

## When to ignore it
When the image is copied to the robot by other means.

## References
- nav2_map_server, map_io.cpp
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule


@rule("error", symptoms=["Failed processing YAML file", "Failed to load image file"])
def map_image_missing(robot: Robot) -> Iterator[Finding]:
    for image, beside, is_of_home in robot.lost_map_images:
        yield finding(
            image,
            f"There is no {image}{' on the robot' if is_of_home else ''}: map_server does not load the map, and "
            "navigation does not start",
            advice=f"write {beside}" if is_of_home else f"the image in this folder is {beside}",
            severity="warning" if is_of_home else None,
        )
