"""A definition of a message, service or action that rosidl refuses.

## What it finds
In the `.msg`, `.srv` and `.action` files from which a package generates interfaces: types that are neither primitive
nor a message (`flaot64`), messages that the package, or another one of the tree, does not have, and messages that are
nearly those of a common package (`std_msgs/Headder`), names of files that are not in upper camel case
(`msg/wheel_state.msg`), names of fields that are not lower case with underscores, names of constants that are not upper
case, names that are there twice, lines without a name, bad sizes of arrays, and another number of `---` than the kind
of interface has.

## Why it matters on a robot
The build of the package stops, and so does that of each package that depends on it.

## Bad
```
Header header
flaot64 wheelSpeed
```

## Good
```
std_msgs/Header header
float64 wheel_speed
```

## When to ignore it
When a step before the build rewrites the file.

## References
- rosidl_adapter 4.6, `parser.py` (compared in `tests/oracles/`)
- https://docs.ros.org/en/jazzy/Concepts/Basic/About-Interfaces.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Problem
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule

_SAID = {
    "type": "{word} is no type",
    "unknown": "There is no message {word}",
    "array": "{word} is no array",
    "no-name": "The field {word} has no name",
    "file-name": "{word} has no name of an interface",
    "field-name": "{word} is not a name of a field",
    "constant-type": "{word} is not a type of a constant",
    "constant-name": "{word} is not a name of a constant",
    "twice": "{word} is there twice",
    "separators": "The number of lines with --- is wrong",
}
_ADVICE = {
    "type": "write a primitive type or a message",
    "unknown": "write a message that exists, with its package",
    "array": "write [], [N] or [<=N]",
    "no-name": "write a type and a name",
    "file-name": "rename the file: a capital letter, then letters and digits",
    "field-name": "write lower case letters, digits and single underscores",
    "constant-type": "write a primitive type",
    "constant-name": "write upper case letters, digits and single underscores",
    "twice": "remove one of them, or rename it",
    "separators": "write one line --- in a service and two in an action, without blanks",
}


@rule(
    "error",
    symptoms=["is an invalid message name. It should have the pattern", "is an invalid field name", "Error processing"],
)
def interface_refused(robot: Robot) -> Iterator[Finding]:
    for each in robot.dependencies.refused_definitions:
        first, *others = each.problems
        yield finding(
            first.span,
            f"{_said(first)}: the build of {each.package.name} stops",
            advice=f"write {first.detail}" if first.detail else _ADVICE[first.code],
            related=[
                *(note(other.span, f"also refused: {_said(other)}") for other in others),
                note(each.package.place, f"the package {each.package.name}"),
            ],
        )


def _said(problem: Problem) -> str:
    return _SAID[problem.code].format(word=problem.span.text)
