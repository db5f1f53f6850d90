"""A launch file receives an argument that it does not declare.

## What it finds
Keys in `launch_arguments` (`<arg>` inside `<include>`) that the launched file and everything it includes neither
declare nor read. Of files in packages that are not in the tree, those of Nav2, slam_toolbox, the drivers of Universal
Robots, RPLIDAR and Velodyne, rosbridge, robot_localization, Gazebo, TurtleBot and others are known. The same for
arguments of `rs_launch.py` of realsense2_camera that newer releases have under another name, be they passed or only
declared around the include, unless the tree is for a distribution that never got these, or fetches an older one.
`name:=value` in the `ros2 launch` commands of units, and of compose services that are built from this tree, is checked
in the same way. Silent where nothing is lost: an empty value, `use_sim_time:=false` for a file that says nothing of it,
and `use_X` that is off beside an empty `X`. An info where the value asks for what happens anyway: it switches off what
no launched file speaks of, it is the default, or `none` as that, of the argument whose name ends so, or all parameter
files of the tree have it.

## Why it matters on a robot
launch accepts any name. It ignores the value silently, and the included part runs with its default: with simulated
time, with the wrong map, or in the wrong namespace.

## Bad
```python
IncludeLaunchDescription(slam, launch_arguments={'use_sim': 'true'}.items())   # slam.launch.py declares use_sim_time
```

## Good
```python
IncludeLaunchDescription(slam, launch_arguments={'use_sim_time': 'true'}.items())
```

## When to ignore it
When one call serves several versions of the included file, and only some of them declare the argument.

## References
- launch, `IncludeLaunchDescription`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.spelling import longer
from bringup_lint.api.spelling import nearest


@rule("warning", fix="unsafe", silent="launch accepts every name without a message")
def include_unknown_arg(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        if robot.purpose(file.source).value == "test":
            continue
        for include in robot.launch.expansion(file).includes:
            if include.source is not file or include.target is None:
                continue
            names = [launch.literal(key) for key, _ in include.action.arguments]
            inner = robot.launch.expansion(include.target)
            idle = launch.passed_without_effect(include.action.arguments, inner)
            own = [name for name in names if name and not launch.read_elsewhere(robot.launch, name, file, inner.files)]
            values = {str(launch.literal(key)): value for key, value in include.action.arguments}
            yield from unknown(robot, [name for name in own if name not in idle], include.target, values)
        yield from _of_public(robot, file)
        yield from _renamed(robot, file)
    for command in (*robot.runners.launches, *robot.runners.typed_launches):
        if command.file is not None and command.runner.certain:
            given = [
                (launch.Literal(name, name.span), launch.Literal(text, text.span)) for name, text in command.arguments
            ]
            idle = launch.passed_without_effect(given, robot.launch.expansion(command.file))
            values = {str(name.value): value for name, value in given}
            yield from unknown(robot, [name for name, _ in command.arguments if name not in idle], command.file, values)


def _of_public(robot: Robot, file: launch.LaunchFile) -> Iterator[Finding]:
    """Arguments that launch files of public packages do not take."""
    for each in launch.untaken(robot.launch, file):
        if robot.dependencies.is_forked(each.package):
            continue
        yield finding(
            each.name,
            f"'{each.name}' is not an argument of {each.target} in any distribution: the value is silently ignored",
            advice=f"pass '{each.near}'" if each.near else "remove it",
            chain=robot.provenance.chain_to(each.name, f"'{each.name}' is passed"),
        )


def _renamed(robot: Robot, file: launch.LaunchFile) -> Iterator[Finding]:
    """Arguments that launch files of public packages had in older releases."""
    for (name, target, gone), *others in launch.gone_arguments(robot.launch, file):
        if robot.dependencies.is_kept_before(gone.package, gone.named):
            continue
        more = f" and {len(others)} other{'s' if len(others) > 1 else ''}" if others else ""
        yield finding(
            name,
            f"{target} of newer releases of {gone.package} has no argument '{name}'{more}: "
            "the value is silently ignored",
            advice=f"pass '{gone.now}'",
            related=[note(each.name, f"'{each.gone.now}' is the name now") for each in others[:10]],
            chain=robot.provenance.chain_to(name, f"'{name}' is passed"),
            confidence="medium",
        )


def unknown(
    robot: Robot, names: list[Located], target: launch.LaunchFile, values: dict[str, launch.Value]
) -> Iterator[Finding]:
    inner = robot.launch.expansion(target)
    if inner.open or launch.reads_unseen(robot.launch, inner.files):
        return
    known = {each.name for each in inner.declared} | launch.read_in(robot.launch, inner.files)
    for name in names:
        if name in known or name in launch.OF_LAUNCH:
            continue
        free = sorted(known - set(names))
        near = nearest(name, free, 3)
        fuller = longer(name, free)
        meant = near or (fuller if len(fuller) == 1 and fits(values[str(name)], fuller[0], inner) else [])
        yield finding(
            name,
            f"'{name}' is not an argument of {target.source.basename}: the value is silently ignored",
            advice=f"pass '{meant[0]}'" if meant else "remove it, or declare it there",
            related=[note(target.entry or target.source, "the launched file")],
            chain=robot.provenance.chain_to(name, f"'{name}' is passed"),
            fix=fix(f"pass '{near[0]}'", (name, near[0]), safe=False)
            if len(near) == 1 and name.span.text == name
            else None,
            severity="info"
            if not near and launch.happens_anyway(str(name), values[str(name)], inner, robot.files)
            else None,
        )


def fits(value: launch.Value, name: str, inner: launch.Expansion) -> bool:
    """Whether a value is a truth value just where the default of an argument is one."""
    defaults = [each.action.default for each in inner.declared if each.name == name]
    return any(each is not None and (launch.truth(each) is None) is (launch.truth(value) is None) for each in defaults)
