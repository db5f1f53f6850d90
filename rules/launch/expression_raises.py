"""A Python expression of a launch file ends with an exception.

## What it finds
`PythonExpression` (`$(eval ...)`) in the condition of an action whose text, with the defaults of the arguments, names
something that Python does not know, as `not true` where the default of an argument is `true` and not `True`, or a text
that lacks its quotes; and texts that are no expression. Silent where every command of the tree that launches the file
passes one of the arguments. A warning where launch comes to the condition only with some arguments, and for `true` and
`false` that are no default and among the `choices` of the argument, in conditions and elsewhere.

## Why it matters on a robot
launch evaluates the text as Python. `true` and `false` are no names there: the whole launch aborts, with a NameError.
In the file itself nothing looks wrong, and `True` on the command line works.

## Bad
```python
DeclareLaunchArgument("slam", default_value="false"),
Node(..., condition=IfCondition(PythonExpression(["not ", LaunchConfiguration("slam")])))
```

## Good
```python
DeclareLaunchArgument("slam", default_value="false"),
Node(..., condition=UnlessCondition(LaunchConfiguration("slam")))
```

## When to ignore it
When the file is only launched by hand with a value that Python knows.

## References
- launch, `PythonExpression.perform`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Related
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.launch import Expansion
from bringup_lint.api.launch import Failed

WORDS = ("true", "false")


@rule(
    "error", symptoms=["name 'true' is not defined", "name 'false' is not defined", "InvalidConditionExpressionError"]
)
def expression_raises(robot: Robot) -> Iterator[Finding]:
    said = set()
    for expansion in robot.launch.entries:
        if robot.launch.is_named_elsewhere(expansion.entry):
            continue
        passed = robot.runners.always_passed(expansion.entry)
        for each in expansion.failed:
            if each.span in said or each.names & passed or not each.file.source.judged:
                continue
            said.add(each.span)
            yield finding(
                each.span,
                f"launch evaluates `{each.text.strip()}`: {each.error}, and the launch aborts",
                advice=_advice(each),
                related=[*_defaults(expansion, each), *(note(span, "included from here") for span in each.chain)],
                severity=None if each.by_default else "warning",
            )
    for file in robot.launch.judged:
        yield from _allowed(robot, file)


def _allowed(robot: Robot, file: launch.LaunchFile) -> Iterator[Finding]:
    for each in launch.allowed_words(robot.launch, file):
        yield finding(
            each.expression.span,
            f"With {each.name}:={each.word} launch evaluates `{each.text.strip()}`: {each.error}, and it aborts",
            advice="compare it as a text ('true'), or leave only True and False among the choices",
            related=[note(each.word, f"'{each.word}' is one of the choices of '{each.name}'")],
            severity="warning",
        )


def _defaults(expansion: Expansion, failed: Failed) -> Iterator[Related]:
    for each in expansion.declared:
        if each.name in failed.names and each.action.default is not None and each.before is None:
            yield note(each.action.default.span, f"'{each.name}' has this value unless another one is passed")


def _advice(failed: Failed) -> str:
    if any(f"'{word}'" in failed.error for word in WORDS):
        return "compare it as a text ('true'), or use UnlessCondition, AndSubstitution and the like"
    return "put quotes around what is a text" if "name" in failed.error else "correct the expression"
