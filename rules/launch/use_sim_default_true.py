"""A launch file of a real robot uses simulated time by default.

## What it finds
Arguments such as `use_sim_time`, `use_sim` or `simulation` with the default true, in launch files that are not for
a simulator. An error where a unit, container or script of the tree launches the file without the argument, a warning
where another launch file includes it without the argument, or a script names such a command. Info where nothing of the
tree starts it. Silent where every command that launches it passes the argument, and every include.

## Why it matters on a robot
Started without arguments, as a unit does it, the nodes wait for a clock that nobody publishes. Nothing moves, and
nothing is logged.

## Bad
```python
DeclareLaunchArgument('use_sim_time', default_value='true')
```

## Good
```python
DeclareLaunchArgument('use_sim_time', default_value='false')
```

## When to ignore it
When the package is for simulation only, and neither its name nor its launch files show that.

## References
- ROS 2 design, "Clock and Time"
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import simulated_by_default


@rule("error", fix="unsafe", symptoms=["No clock received, using time argument instead!"])
def use_sim_default_true(robot: Robot) -> Iterator[Finding]:
    for name, default, started, omitted in simulated_by_default(robot.launch, robot.runners):
        word = default.text
        where = word if word.span.text == word else default.span
        false = "false" if where is word else "'false'"
        yield finding(
            where,
            f"{name} is true by default: started without arguments, the nodes wait for a simulated clock",
            advice="make the default false and pass true in the simulation",
            chain=robot.provenance.chain_to(where, f"{name} is true unless a caller passes false"),
            fix=fix("make the default false", (where, false), safe=False),
            related=[note(omitted, f"started here without {name}")] if omitted else [],
            severity=None if started else "warning" if omitted else "info",
        )
