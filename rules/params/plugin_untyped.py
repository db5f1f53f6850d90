"""A server of Navigation2 is told to load a plugin without its class.

## What it finds
Names in `controller_plugins`, `goal_checker_plugins`, `progress_checker_plugins`, `planner_plugins`,
`smoother_plugins`, `behavior_plugins` and in `plugins` and `filters` of a costmap, for which the file holds no
`<name>.plugin`. Left out are lists that are just the default of the server, which then knows the classes itself, and
nodes that are given several parameter files.

## Why it matters on a robot
The server says "Can not get 'plugin' param value" and ends when it configures. The lifecycle manager then takes the
whole navigation down. It happens with a section that was renamed and a list that was not.

## Bad
```yaml
controller_server:
  ros__parameters:
    goal_checker_plugins: ["precise_checker"]
    general_goal_checker:
      plugin: "nav2_controller::SimpleGoalChecker"
```

## Good
```yaml
controller_server:
  ros__parameters:
    goal_checker_plugins: ["general_goal_checker"]
    general_goal_checker:
      plugin: "nav2_controller::SimpleGoalChecker"
```

## When to ignore it
When something that the linter does not see adds the section before the server starts.

## References
- navigation2, nav2_util/node_utils.hpp, `get_plugin_type_param`
- https://docs.nav2.org/configuration/
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
        "Can not get 'plugin' param value for",
        "'plugin' param not defined for",
        "No 'plugin' param for param ns!",
    ],
)
def plugin_untyped(robot: Robot) -> Iterator[Finding]:
    for each, *others in robot.plugins.untyped:
        like = each.like.name.removesuffix(".plugin") if each.like is not None else None
        near = [note(each.like.span, "no list names this one")] if each.like is not None else []
        yield finding(
            each.where,
            f"{each.server} has no {each.name}.plugin: it ends when it configures, and navigation does not come up",
            advice=f"write {like}, or rename its section" if like else f"add a section {each.name} with its plugin",
            related=[*near, *(note(other.where, f"{other.server} has no {other.name}.plugin") for other in others)],
            severity=None if each.used else "warning" if like else "info",
        )
