"""The default of a truth value is written as a text, which is true.

## What it finds
In C++ `declare_parameter<bool>("x", "false")` and `get_parameter_or<bool>("x", x, "false")`: a default that means no
and is a string literal. It is a warning where everything that starts the node gives it the parameter, and an info where
a statement before it, in a block around it, declares it: then it has a value, or the declaration has thrown before.

## Why it matters on a robot
A string literal is an address, and an address converts to `true`, whatever the text says. The compiler accepts it, with
`-Wall -Wextra` too. Without the parameter the robot does what the source says that it shall not do: it publishes a
second odometry transform, or drives in another mode.

## Bad
```cpp
get_parameter_or<bool>("publish_tf", publish_tf_, "false");
```

## Good
```cpp
get_parameter_or<bool>("publish_tf", publish_tf_, false);
```

## When to ignore it
When everything that starts the node sets the parameter.

## References
- C++ standard, [conv.bool]
- tried with g++ 12.2
- rclcpp, node.hpp: `declare_parameter` and `get_parameter_or` take the default as `const ParameterT &`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule

MEANS_NO = frozenset({"", "0", "false", "no", "off"})


@rule("error", silent="the text converts to true without a message")
def bool_from_text(robot: Robot) -> Iterator[Finding]:
    for source in robot.nodes.cpp:
        for name, text, is_declared in source.texts_as_bool:
            if text.lower() in MEANS_NO:
                is_given = name is not None and robot.topics.is_always_given(source.source, name)
                yield finding(
                    text,
                    f'"{text}" is a text, and its address converts to true: without the parameter this is on',
                    advice="write false without quotes",
                    severity="info"
                    if is_declared
                    else robot.nodes.lowered(source.source, "warning" if is_given else "error"),
                )
