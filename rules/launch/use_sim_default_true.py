"""A launch file of a real robot uses simulated time by default.

## What it finds
Arguments such as `use_sim_time`, `use_sim` or `simulation` with the default true, in launch files that are not for a
simulator. An error where a unit, container or script of the tree launches the file without the argument, a warning
where another launch file includes it without the argument, or a script names such a command, and where nothing of the
tree is about a simulation. Info where nothing of the tree starts it. Silent where every command that launches it passes
the argument, and every include, and where the file ends before, as `launch/substitution-as-value` says.

Also `use_sim_time: True` that no argument can change, in parameters of nodes, `SetParameter` and arguments of includes,
in a tree where nothing is about a simulation or a recording. It is an error for the nodes of Nav2 and others that wait
for ROS time, and a warning for others.

A warning, too, where `online_async_launch.py` of slam_toolbox and others of which the default is true are started
without the argument, and the tree has no simulation, or the parameter file that is passed says `use_sim_time: false`:
their argument overrules the file.

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
from bringup_lint.api.launch import Literally
from bringup_lint.api.launch import simulated_by_default
from bringup_lint.api.launch import simulated_by_public
from bringup_lint.api.launch import simulated_literally
from bringup_lint.api.launch import simulates_nothing

FALSE = {
    "True": "False",
    "true": "false",
    "'true'": "'false'",
    '"true"': '"false"',
    "'True'": "'False'",
    '"True"': '"False"',
}


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
            severity=None if started else "warning" if omitted or simulates_nothing(robot.files) else "info",
        )
    yield from _in_any_case(robot)
    for of in simulated_by_public(robot.launch, robot.runners):
        yield finding(
            of.where,
            f"{of.file} of {of.package} has use_sim_time true by default: its nodes get a simulated clock that nobody "
            "publishes, and their time stays at zero",
            advice="pass use_sim_time false",
            related=[note(of.overruled, "overruled by the argument of the launch file")] if of.overruled else [],
            chain=robot.provenance.chain_to(of.where, "the argument is not passed"),
            severity="warning",
        )


def _in_any_case(robot: Robot) -> Iterator[Finding]:
    """What no argument can change; one finding for each launch file."""
    groups: dict[str, list[Literally]] = {}
    for each in simulated_literally(robot.launch, robot.files):
        groups.setdefault(each.where.source.name, []).append(each)
    for places in groups.values():
        first, *others = sorted(places, key=lambda each: not each.is_waiting)
        yield finding(
            first.where,
            f"{first.label} gets a simulated clock in any case, and nothing of this tree simulates: its time stays at "
            "zero"
            + (", and what it does by that time, as to compare the age of transforms, goes wrong" * first.is_waiting),
            advice="write false, or leave it out",
            related=[note(each.where, f"{each.label} gets it here") for each in others],
            fix=fix("write false", *((each.where, FALSE[each.where.text]) for each in places), safe=False)
            if all(each.where.text in FALSE for each in places)
            else None,
            severity=None if first.is_waiting else "warning",
        )
