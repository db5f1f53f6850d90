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
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

NAMES = ("use_sim_time", "use_sim", "sim", "simulation", "use_simulation", "is_sim", "is_simulation", "sim_mode")


@rule("error", fix="unsafe", symptoms=["No clock received, using time argument instead!"])
def use_sim_default_true(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if robot.launch.simulated(file):
            continue
        for action, _ in robot.launch.visited(file):
            if not isinstance(action, launch.DeclareArgument):
                continue
            name = launch.literal(action.name)
            if name not in NAMES:
                continue
            default = action.default
            if default is None or not isinstance(default, launch.Literal) or launch.truth(default) is not True:
                continue
            word = default.text
            where = word if word.span.text == word else default.span
            false = "false" if where is word else "'false'"
            starters = robot.runners.launching(file)
            if starters and all(name in {str(given) for given, _ in each.arguments} for each in starters):
                continue
            omitted = next(robot.launch.started_without(file, name), None)
            if not sets_clock(robot, file, name) or (omitted is None and not starters and passed(robot, file, name)):
                continue
            yield finding(
                where,
                f"{name} is true by default: started without arguments, the nodes wait for a simulated clock",
                advice="make the default false and pass true in the simulation",
                chain=robot.provenance.chain_to(where, f"{name} is true unless a caller passes false"),
                fix=fix("make the default false", (where, false), safe=False),
                related=[note(omitted, f"started here without {name}")] if omitted else [],
                severity=None if starters else "warning" if omitted else "info",
            )


def sets_clock(robot: Robot, file: launch.LaunchFile, name: str) -> bool:
    """Whether the argument is read where nodes are given the simulated clock."""
    files = robot.launch.expansion(file).files
    return name in robot.launch.read_in(files) and any("use_sim_time" in each.source.text for each in files)


def passed(robot: Robot, file: launch.LaunchFile, name: str) -> bool:
    """Whether another launch file includes this one and passes the argument."""
    return any(
        include.target is file and name in include.arguments
        for expansion in robot.launch.leading_to(file)
        for include in expansion.includes
    )
