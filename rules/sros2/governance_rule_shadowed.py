"""A topic rule that is never used.

## What it finds
A topic rule behind one whose expression covers all its topics, with other settings.

## Why it matters on a robot
The first rule that matches decides: the later rule, usually the stricter one, has no effect.

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

## References
- OMG DDS Security 1.1, clause 9.4.1.2.5
"""

import re

from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning")
def governance_rule_shadowed(robot: Robot):
    for governance in robot.sros2.used_governances:
        for rule_ in governance.rules:
            before = []
            for topics in rule_.topic_rules:
                if topics.expression is None:
                    continue
                wider = next((each for each in before if _covers(robot, each.expression, topics.expression)), None)
                before.append(topics)
                if wider is not None and wider.fields != topics.fields:
                    yield finding(
                        topics.expression,
                        f"The rule for {topics.expression} is never used: '{wider.expression}' stands before it, and "
                        "the first match wins",
                        advice="put the specific rules first, and sign the document again",
                        related=[note(wider.expression, "this rule decides")],
                    )


def _covers(robot, wide, narrow):
    if wide == "*" or wide == narrow:
        return True
    return not re.search(r"[*?\[]", narrow) and robot.sros2.matches(narrow, wide)
