"""A node that fails ends with status 0.

## What it finds
A `try` of `main` around a spin whose handler of `std::exception`, `std::runtime_error`, `...` or `Exception` only
reports, where `main` returns nothing but 0 and the source has no other way to end with a status. In C++ also a loop
`while (started && rclcpp::ok())` that is left out after `main` has logged the failure. It is a warning where a unit, a
container or a program of supervisord is this node alone (by `ros2 run` or its path, others only in the background) and
is started again only after a failure, or has an `OnFailure=`. It is an info elsewhere: `ros2 launch` and its `respawn`
do not look at the status. The programs of a package are one finding.

## Why it matters on a robot
What a callback throws ends the spin, and with it the node. The status says that all went well: `Restart=on-failure`,
`restart: on-failure` and `autorestart=unexpected` leave the node down, `OnFailure=` does not run, and launch says
"process has finished cleanly" between the lines of the other nodes. A safety node or a driver is gone, and nothing is
red.

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
        key = (owner, robot.nodes.purpose(source), nodes.watcher(robot.nodes, source))
        alike.setdefault(key, []).extend(found)
    for first, *others in alike.values():
        source = first.place.source
        runner = nodes.watcher(robot.nodes, source)
        end = "launch says 'finished cleanly', and nothing that waits for a failure starts it again"
        if runner is not None:
            end = f"{runner.name} takes it for a regular end, and leaves it down"
        yield finding(
            first.place,
            f"A failure ends this node with status 0: {end}",
            advice="raise it again in the handler" if source.name.endswith(".py") else _return(first),
            related=[
                note(first.spin, _CAUSES[first.is_caught]),
                *([note(runner.where, "looks at the status")] if runner is not None else []),
                *(note(each.place, "this handler does the same") for each in others),
            ],
            severity=robot.nodes.lowered(source, "warning") if runner is not None else "info",
        )


def _return(found: nodes.Swallowed) -> str:
    return "return EXIT_FAILURE here" if found.is_caught else "return EXIT_FAILURE where the failure is logged"
