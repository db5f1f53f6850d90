"""A constructor asks for the shared pointer of the object that it still makes.

## What it finds
`shared_from_this()` that the constructor of a C++ class calls on the object itself: in its body, in its list of
initializers, or in a method of the class that it calls. Lambdas, branches and `try` blocks are left out, because they
may run later, not at all, or expect the exception.

## Why it matters on a robot
The pointer exists only after the constructor has returned to `std::make_shared`. Until then `shared_from_this()`
throws `std::bad_weak_ptr`: the node terminates each time it starts, and a component is not loaded.

## Bad
```cpp
Camera() : Node("camera"), transport_(shared_from_this()) {}
```

## Good
```cpp
Camera() : Node("camera") {
  publisher_ = image_transport::create_publisher(this, "image_raw");
}
```

## When to ignore it
Never; move the call to a method that runs after the node was made.

## References
- C++ standard, [util.smartptr.enab]: `shared_from_this` throws when no `shared_ptr` owns the object
- rclcpp, node.hpp: `Node` derives from `std::enable_shared_from_this`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("error", symptoms=["terminate called after throwing an instance of 'std::bad_weak_ptr'", "bad_weak_ptr"])
def shared_from_constructor(robot: Robot) -> Iterator[Finding]:
    for node in robot.nodes.cpp:
        if not node.early_pointers:
            continue
        first, *others = node.early_pointers
        through = [note(first.through, "the constructor calls it here")] if first.through is not None else []
        yield finding(
            first.asked,
            f"shared_from_this() throws bad_weak_ptr in the constructor of {first.owner}: nothing owns the object yet",
            advice="give 'this' instead, or do it in a method that runs after std::make_shared",
            related=[*through, *(note(each.asked, "so does this one") for each in others)],
            severity=nodes.lowered(robot.nodes.purpose(node.source), "error"),
        )
