"""A component class is loaded that its package does not register.

## What it finds
`ComposableNode(plugin=...)` of workspace packages whose CMakeLists.txt registers other classes, or that are pure Python
packages.

## Why it matters on a robot
The container logs an error and goes on without the component: everything looks started, and one node is missing.

## Bad
```python
ComposableNode(package='my_vision', plugin='my_vision::DetectorNode')   # registered: my_vision::Detector
```

## Good
```python
ComposableNode(package='my_vision', plugin='my_vision::Detector')
```

## References
- rclcpp_components, `rclcpp_components_register_node`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import nearest


@rule(
    "error",
    symptoms=[
        "Could not find requested resource in ament index",
        "Failed to find class with the requested plugin name",
    ],
)
def plugin_missing(robot: Robot) -> Iterator[Finding]:
    for node in robot.launch.nodes:
        package = robot.launch.workspace.packages.get(launch.literal_text(node.package) or "")
        plugin = launch.literal_text(node.plugin)
        if package is None or plugin is None or not package.plugins_known or plugin in package.plugins:
            continue
        if package.manifest.build_type == "ament_python":
            message = (
                f"{package.name} is a Python package, containers load only C++ classes: '{plugin}' is never loaded"
            )
            yield finding(plugin, message, advice="start it as a node of its own")
            continue
        near = nearest(plugin, package.plugins, 6)
        yield finding(
            plugin,
            f"Component {plugin} is not registered by {package.name}: the container runs without it",
            advice=f"load {near[0]}" if near else "register the class with rclcpp_components_register_node",
            chain=robot.provenance.chain_to_node(node),
            related=[note(near[0], "this class is registered")]
            if near
            else [note(package.builds[0].source, "what the package registers")],
        )
