"""Images are copied although their nodes share a process.

## What it finds
Containers with several components, at least one of them from an image package, where no component sets
`use_intra_process_comms`.

## Why it matters on a robot
Composition alone is not zero-copy: every image still goes through the middleware and costs CPU time and memory.

## Bad
```python
ComposableNode(package='image_proc', plugin='image_proc::RectifyNode', name='rectify')
```

## Good
```python
ComposableNode(package='image_proc', plugin='image_proc::RectifyNode', name='rectify',
               extra_arguments=[{'use_intra_process_comms': True}])
```

## When to ignore it
When the images are small or rare, or when a publisher needs a QoS that intra-process communication does not
support, such as transient local on older distributions.

## References
- rclcpp, intra-process communication
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import rule
from bringup_lint.api.python import all_of
from bringup_lint.api.python import with_item

IMAGES = (
    "image_proc",
    "stereo_image_proc",
    "depth_image_proc",
    "usb_cam",
    "v4l2_camera",
    "realsense2_camera",
    "image_tools",
)


@rule("info", fix="unsafe", silent="copies are not reported; only the processor load shows them")
def intra_process_unset(robot: Robot) -> Iterator[Finding]:
    for _, node in robot.launch.actions(launch.Node):
        components = [each for each in node.components if isinstance(each, launch.ComposableNode)]
        images = any(launch.literal(each.package) in IMAGES for each in components)
        known = len(components) == len(node.components) and not any(each.open for each in components)
        set_ = any(
            "use_intra_process_comms" in str(launch.literal(each))
            for one in components
            for value in one.extra_arguments
            for each in launch.walk(value)
        )
        if images and known and len(components) > 1 and not set_:
            item = "{'use_intra_process_comms': True}"
            change = all_of(*(with_item(each.span, "extra_arguments", item) for each in components))
            yield finding(
                node.span,
                f"{len(components)} components share a process but still copy every image",
                advice="give them extra_arguments=[{'use_intra_process_comms': True}]",
                fix=fix("let them share images", codemod=change, safe=False) if change else None,
            )
