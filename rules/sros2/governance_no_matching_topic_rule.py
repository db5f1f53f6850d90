"""No governance rule covers a topic.

## What it finds
A topic that no `topic_rule` of its domain matches, and that is either `ros_discovery_info`, which every
process needs, or granted to an enclave of the keystore by its full name.

## Why it matters on a robot
The library cannot create a topic without a rule (code 142): the node ends with an exception.

## Bad
```xml
<topic_rule>
  <topic_expression>rt/*</topic_expression>
```

## Good
```xml
<topic_rule>
  <topic_expression>rt/*</topic_expression>
  ...
<topic_rule>
  <topic_expression>*</topic_expression>
```

## When to ignore it
If the grant is left over and no node uses the topic. The finding for `ros_discovery_info` is always right.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.sros2 import matches


@rule("error", symptoms=["topic attributes for domain"])
def governance_no_matching_topic_rule(robot: Robot) -> Iterator[Finding]:
    for governance in robot.sros2.used_governances:
        granted = [
            topic
            for permissions, grant in robot.sros2.ros_grants
            if governance in robot.sros2.governances_of(permissions.source)
            for rule_ in grant.allowed
            for topic in (*rule_.publish, *rule_.subscribe)
            if not re.search(r"[*?\[]", topic)
        ]
        for rule_ in governance.rules:
            expressions = [topics.expression for topics in rule_.topic_rules if topics.expression is not None]
            topic_rules = rule_.element.find("topic_access_rules")
            if topic_rules is None or len(expressions) < len(rule_.topic_rules) or not expressions:
                continue
            names = {str(topic): topic for topic in granted}
            open_ = [
                name for name in ["ros_discovery_info", *names] if not any(matches(name, each) for each in expressions)
            ]
            if open_:
                shown = ", ".join(dict.fromkeys(open_[:3])) + (" and others" if len(set(open_)) > 3 else "")
                yield finding(
                    topic_rules.tag,
                    f"No topic rule covers {shown}: the topic cannot be created (code 142), its nodes do not start",
                    advice="end with a rule for *, and sign the document again",
                    related=[note(names[name], "granted here") for name in open_ if name in names][:3],
                )
