"""A component class is loaded that its package does not register.

## What it finds
`ComposableNode(plugin=...)` of a workspace package whose CMakeLists.txt registers other classes, or that is a pure
Python package.

## Why it matters on a robot
The container logs an error and continues without the component. Everything looks started, but one node is missing.

## Bad
```python
ComposableNode(package='my_vision', plugin='my_vision::DetectorNode')   # registered: my_vision::Detector
```

## Good
```python
ComposableNode(package='my_vision', plugin='my_vision::Detector')
```

## When to ignore it
When a macro that the linter cannot read registers the class. A Python package can never provide a component.

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
        "Failed to load node '*' of type '*' in container",
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
                f"{package.name} is a Python package, and containers load only C++ classes: '{plugin}' never loads"
            )
            yield finding(plugin, message, advice="start it as a separate node")
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
