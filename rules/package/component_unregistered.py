"""A component is built under a name that no source registers.

## What it finds
`rclcpp_components_register_node` and `rclcpp_components_register_nodes` of a CMakeLists.txt with a class that no source
of the package gives to `RCLCPP_COMPONENTS_REGISTER_NODE`, where the sources register other classes. A class that is
registered twice, where one of the sources is left out, is a warning. It is an info where no executable of the build and
no launch file loads the component, and a program makes an object of the class itself. Silent where a source registers
classes by a macro of its own.

## Why it matters on a robot
The build succeeds: CMake writes the name into the ament index and compares it with nothing. When a container loads the
component, and when the executable of the component starts, class_loader has no class of this name. The node never runs.

## Bad
```cmake
rclcpp_components_register_node(camera PLUGIN "vision::Camera" EXECUTABLE camera_node)
# camera.cpp: RCLCPP_COMPONENTS_REGISTER_NODE(my_vision::Camera)
```

## Good
```cmake
rclcpp_components_register_node(camera PLUGIN "my_vision::Camera" EXECUTABLE camera_node)
```

## When to ignore it
When the source that registers the class is made by the build.

## References
- rclcpp_components, `register_node_macro.hpp` and `ComponentManager::create_component_factory`
- class_loader, `register_macro.hpp`: the name is the text that the macro is given
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["Could not find requested resource"])
def component_unregistered(robot: Robot) -> Iterator[Finding]:
    for package in robot.launch.workspace.packages.values():
        if not robot.dependencies.judged(package):
            continue
        for each in robot.dependencies.unregistered(package):
            if each.first is not None:
                yield _doubled(each.name, each.registered, each.first)
                continue
            is_longer = each.registered.endswith(each.name.rpartition(":")[2])
            yield finding(
                each.name,
                f"No source of {package.name} registers the component {each.name}: it is never loaded",
                advice=f"write {each.registered}"
                if each.is_same or is_longer
                else "write a class that a source registers",
                related=[note(each.registered, "this class is registered")],
                severity="info" if each.is_spare else None,
            )


def _doubled(name: Located, left: Located, first: Located) -> Finding:
    return finding(
        name,
        f"{name} is registered twice, and {left} is not: the second one runs {name}, and {left} is never loaded",
        advice=f"write {left}",
        related=[note(first, "registered here before"), note(left, "this class is left out")],
        severity="warning",
    )
