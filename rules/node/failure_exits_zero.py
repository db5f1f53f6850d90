"""A node that fails ends with status 0.

## What it finds
A `try` of `main` around a spin whose handler of `std::exception`, `std::runtime_error`, `...` or `Exception` only
reports, where `main` returns nothing but 0 and the source has no other way to end with a status. In C++ also a loop
`while (started && rclcpp::ok())` that is left out after `main` has logged the failure. It is a warning where units,
containers or the like start the programs of the robot, and an info where people do. The programs of a package are one
finding.

## Why it matters on a robot
What a callback throws ends the spin, and with it the node. The status says that all went well: `Restart=on-failure` and
`restart: on-failure` leave the node down, `OnFailure=` does not run, and launch says "process has finished cleanly"
between the lines of the other nodes. A safety node or a driver is gone, and nothing is red.

## Bad
```python
except Exception as error:
    node.get_logger().error(f"failed: {error}")
```

## Good
```python
except Exception as error:
    node.get_logger().error(f"failed: {error}")
    raise
```

## When to ignore it
When whatever starts the node starts it again after each end, as `Restart=always` does.

## References
- launch, execute_local.py: "process has finished cleanly" for status 0, "process has died" for others
- systemd.service(5), `Restart=`
- tried with CPython 3.11 and g++ 12.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import nodes
from bringup_lint.api import note
from bringup_lint.api import rule

_CAUSES = {True: "what a callback throws comes out here", False: "the failure is logged here"}


@rule("warning", symptoms=["process has finished cleanly"])
def failure_exits_zero(robot: Robot) -> Iterator[Finding]:
    alike: dict[object, list[nodes.Swallowed]] = {}
    for found in nodes.swallowed_failures(robot.nodes):
        source = found[0].place.source
        owner = robot.launch.workspace.owner(source) or source
        alike.setdefault((owner, robot.nodes.purpose(source)), []).extend(found)
    is_supervised = any(map(robot.runners.is_supervised, robot.runners.all))
    for first, *others in alike.values():
        source = first.place.source
        yield finding(
            first.place,
            "A failure ends this node with status 0: Restart=on-failure does not start it again, and launch says "
            "'finished cleanly'",
            advice="raise it again in the handler" if source.name.endswith(".py") else _return(first),
            related=[
                note(first.spin, _CAUSES[first.is_caught]),
                *(note(each.place, "this handler does the same") for each in others),
            ],
            severity=robot.nodes.lowered(source, "warning") if is_supervised else "info",
        )


def _return(found: nodes.Swallowed) -> str:
    return "return EXIT_FAILURE here" if found.is_caught else "return EXIT_FAILURE where the failure is logged"
