"""A class asks for a shared pointer of its own object, which it cannot have.

## What it finds
`shared_from_this()` that the constructor of a C++ class calls on the object itself: in its body, in its list of
initializers, or in a method of the class that it calls. Lambdas, branches and `try` blocks are left out, because they
may run later, not at all, or expect the exception. And `std::shared_ptr<rclcpp::Node>(this)` without a deleter, of a
node, which `std::make_shared` or a container owns already.

## Why it matters on a robot
The pointer exists only after the constructor has returned to `std::make_shared`. Until then `shared_from_this()`
throws `std::bad_weak_ptr`: the node terminates each time it starts, and a component is not loaded. A second pointer
made of `this` does not know of the first: each of them deletes the node, and the program crashes with a double free.

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
from bringup_lint.api import note
from bringup_lint.api import rule


@rule(
    "error",
    symptoms=[
        "terminate called after throwing an instance of 'std::bad_weak_ptr'",
        "bad_weak_ptr",
        "free(): double free detected in tcache 2",
    ],
)
def shared_from_constructor(robot: Robot) -> Iterator[Finding]:
    for node in (each for each in robot.nodes.cpp if each.early_pointers):
        first, *others = node.early_pointers
        through = [note(first.through, "the constructor calls it here")] if first.through is not None else []
        yield finding(
            first.asked,
            f"shared_from_this() throws bad_weak_ptr in the constructor of {first.owner}: nothing owns the object yet",
            advice="give 'this' instead, or do it in a method that runs after std::make_shared",
            related=[*through, *(note(each.asked, "so does this one") for each in others)],
            severity=robot.nodes.lowered(node.source, "error"),
        )
    for node in robot.nodes.cpp:
        for owner in node.second_owners:
            yield finding(
                owner,
                "This pointer deletes a node that another owns and deletes, too: a double free, at the latest at exit",
                advice="give '*this' where a reference does, or call shared_from_this() after the constructor",
                severity=robot.nodes.lowered_if_vendored(node.source, "error"),
            )
