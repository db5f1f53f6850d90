"""A condition is neither true nor false.

## What it finds
`IfCondition` and `UnlessCondition` (`if=`, `unless=`) on a literal that is not one of `true`, `false`, `1` and `0`.
The same holds for an argument whose default is such a literal.

## Why it matters on a robot
launch accepts only these four words, in upper or lower case. `yes`, `on` or an empty string aborts the launch.

## Bad
```xml
<node pkg="demo" exec="talker" if="yes"/>
```

## Good
```xml
<node pkg="demo" exec="talker" if="true"/>
```

## When to ignore it
Only for the default of an argument that every caller passes. A literal in the condition itself always aborts.

## References
- launch, `evaluate_condition_expression`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import launch
from bringup_lint.api import note
from bringup_lint.api import rule

MEANT = {"yes": "true", "on": "true", "y": "true", "no": "false", "off": "false", "n": "false"}


@rule(
    "error", fix="safe", symptoms=["invalid condition expression, expected one of", "InvalidConditionExpressionError"]
)
def condition_literal(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        defaults = {
            each.name: each.action.default
            for each in robot.launch.expansion(file).declared
            if each.file is file and each.action.default is not None
        }
        for condition in robot.launch.conditions(file):
            if condition.kind not in ("if", "unless"):
                continue
            value: launch.Value | None = condition.predicate
            argument = value.name if isinstance(value, launch.Argument) else None
            if argument is not None:
                value = defaults.get(str(argument))
            word = launch.literal(value)
            if value is None or word is None or launch.truth(value) is not None:
                continue
            meant = MEANT.get(word.strip().lower())
            start = f"The default '{word}' of '{argument}'" if argument is not None else f"'{word}'"
            yield finding(
                word,
                f"{start} is neither true nor false: the condition aborts the launch",
                advice=f"write {meant or 'true or false'}",
                related=[note(condition.span, "this condition reads it")] if argument else [],
                fix=fix(f"write {meant}", (word, meant), safe=argument is None)
                if meant and word.span.text == word
                else None,
            )
