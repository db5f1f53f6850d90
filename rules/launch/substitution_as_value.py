"""Python code takes a launch configuration for its value.

## What it finds
`LaunchConfiguration('x')` that is compared with a text, used as a condition, formatted into a text, joined to a path
with `os.path.join`, added to a text, converted to a number, or looked up in a dictionary. Also a `LaunchConfiguration`
instead of a name as the key in `launch_arguments`, or in `LaunchConfigurationEquals` and
`LaunchConfigurationNotEquals`. A comparison with the empty text is a warning, and an info where the default is a text
or a path and no include of the tree gives anything else: what it keeps out seldom comes. A key is a warning where the
included file has the same value as its default.

## Why it matters on a robot
The description is built before launch knows any argument, and the object is not its value. A comparison is always
False, a condition is always true, a text contains `<launch.substitutions.launch_configuration.LaunchConfiguration
object at 0x7f…>`. `os.path.join`, `int` and `+` raise a TypeError, and nothing starts.

## Bad
```python
model = LaunchConfiguration('model')
urdf = os.path.join(get_package_share_directory('rover_description'), 'urdf', model)
```

## Good
```python
model = LaunchConfiguration('model')
urdf = PathJoinSubstitution([FindPackageShare('rover_description'), 'urdf', model])
```

## When to ignore it
Never; give the object to launch, or read its value in an OpaqueFunction with `perform(context)`.

## References
- https://docs.ros.org/en/jazzy/Tutorials/Intermediate/Launch/Using-Substitutions.html
- launch, `LaunchConfiguration.perform`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

ADVICE = "read the value in an OpaqueFunction with perform(context)"
COMPARED = "is a LaunchConfiguration object, not its text: this comparison has the same result whatever the argument is"
EMPTY = "compared with nothing"
"""The comparison that keeps an empty argument out: the defaults seldom are empty."""
EFFECTS = {
    "compared": (COMPARED, "use EqualsSubstitution"),
    EMPTY: (COMPARED, "compare the result of perform(context) in an OpaqueFunction"),
    "condition": ("is an object, which is always true: the argument decides nothing", "use IfCondition"),
    "text": ("is an object: the text holds '<launch.substitutions…>' instead of the value", "write a list of parts"),
    "path": (
        "is an object and no path: launch ends with a TypeError",
        "use PathJoinSubstitution, or where Python opens the file itself, perform(context) in an OpaqueFunction",
    ),
    "added": ("is an object and no text: launch ends with a TypeError", "write a list of parts"),
    "number": ("is an object and no number: launch ends with a TypeError", ADVICE),
    "looked-up": ("is an object: the dictionary has no such key", ADVICE),
    "configuration-name": (
        "stands where its name belongs: no configuration is called so, and the condition never changes",
        "quote the name",
    ),
    "argument-name": ("is the name of an argument here: the include gets one called as its value", "quote the name"),
}


@rule(
    "error",
    symptoms=[
        "argument must be str, bytes, or os.PathLike object, not 'LaunchConfiguration'",
        "'LaunchConfiguration' object has no attribute",
        'can only concatenate str (not "LaunchConfiguration") to str',
        "expected str, bytes or os.PathLike object, not LaunchConfiguration",
    ],
)
def substitution_as_value(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for use in file.objects:
            effect, advice = EFFECTS[use.how]
            yield finding(
                use.span,
                f"The launch configuration '{use.argument.name}' {effect}",
                advice=advice,
                related=[note(use.argument.name, "read here")],
                severity=severity_of(robot, file, use),
            )


def severity_of(robot: Robot, file: launch.LaunchFile, use: launch.ObjectAsValue) -> str | None:
    """That of an argument of an include which is never placed is low."""
    if use.how == "argument-name" and any(each.start <= use.span.start < each.end for each in file.idle):
        return "info"
    if use.how == EMPTY:
        return "info" if is_filled(robot, file, use) else "warning"
    return "warning" if is_default(robot, file, use) else None


def is_filled(robot: Robot, file: launch.LaunchFile, use: launch.ObjectAsValue) -> bool:
    """Whether an argument has a text by default, and whoever includes the file gives it one."""
    name = str(use.argument.name)
    values = [each.action.default for each in robot.launch.expansion(file).declared if each.name == name]
    for expansion in robot.launch.leading_to(file):
        values += (each.values[name] for each in expansion.includes if each.target is file and name in each.values)
    return bool(values) and all(map(has_text, values))


def has_text(value: launch.Value | None) -> bool:
    """Whether a value is a text or a path that cannot be empty."""
    if isinstance(value, launch.Concat | launch.PathJoin):
        return any(map(has_text, value.parts))
    return isinstance(value, launch.PackageShare) or (value is not None and launch.literal(value) not in (None, ""))


def is_default(robot: Robot, file: launch.LaunchFile, use: launch.ObjectAsValue) -> bool:
    """Whether the included file has the value by itself that is meant for its argument."""
    for include in robot.launch.expansion(file).includes:
        here = include.action.span
        is_own = include.source is file and here.start <= use.span.start < here.end
        if use.how == "argument-name" and is_own and include.target is not None:
            given = [launch.literal(value) for key, value in include.action.arguments if key is use.argument]
            declared = robot.launch.expansion(include.target).declared
            defaults = [each.action.default for each in declared if each.name == use.argument.name]
            if given and any(launch.literal(each) == given[0] for each in defaults):
                return True
    return False
