"""A topic rule is never used.

## What it finds
A topic rule after one whose expression covers all its topics but has other settings.

## Why it matters on a robot
The first rule that matches decides. The later rule, usually the stricter one, has no effect.

## Bad
```xml
<topic_expression>*</topic_expression>
...
<topic_expression>rt/cmd_vel</topic_expression>
```

## Good
```xml
<topic_expression>rt/cmd_vel</topic_expression>
...
<topic_expression>*</topic_expression>
```

## When to ignore it
Never: libraries read the rules in order and stop at the first match. Delete the later rule if the first one
is right.

## References
- OMG DDS Security 1.1, clause 9.4.1.2.5
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sros2 import TopicRule
from bringup_lint.api.sros2 import matches


@rule("warning", silent="the first rule that matches applies without a message")
def governance_rule_shadowed(robot: Robot) -> Iterator[Finding]:
    for governance in robot.sros2.used_governances:
        for rule_ in governance.rules:
            before: list[tuple[Located, TopicRule]] = []
            for topics in rule_.topic_rules:
                own = topics.expression
                if own is None:
                    continue
                wide, wider = next((each for each in before if _covers(robot, each[0], own)), (own, topics))
                before.append((own, topics))
                if wider.fields != topics.fields:
                    yield finding(
                        own,
                        f"The rule for {own} is never used: '{wide}' comes before it, and the first match wins",
                        advice="put the specific rules first, and sign the document again",
                        related=[note(wide, "this rule decides")],
                    )


def _covers(robot: Robot, wide: Located, narrow: Located) -> bool:
    if wide == "*" or wide == narrow:
        return True
    return not re.search(r"[*?\[]", narrow) and matches(narrow, wide)
