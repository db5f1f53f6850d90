"""A policy names a node, topic, service or action nearly as others do, and nothing has this name.

## What it finds
In a `policy.xml` and in the profiles that it includes: names that are in one place of the tree, while exactly one
name is a letter away that the policies have in several places, or that a node or launch file has. Numbers and plurals
are other names.

## Why it matters on a robot
`ros2 security create_permission` grants the right for a name that nothing uses. The right one is denied when the robot
runs: the node ends, or its messages and calls never arrive.

## Bad
```xml
<action>/navigate_to_pse</action>
```

## Good
```xml
<action>/navigate_to_pose</action>
```

## When to ignore it
When both names are there on the robot.

## References
- sros2, creation of permissions from a policy
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", fix="unsafe", symptoms=["Not Allowed By Security"])
def policy_name_misspelt(robot: Robot) -> Iterator[Finding]:
    for each in robot.sros2.misspelt_rights:
        yield finding(
            each.name,
            f"Nothing else names the {each.what} {each.name}: the rights are for a name that nothing uses",
            advice=f"write {each.meant}, and create and sign the permissions again",
            related=[note(each.meant, "the name that others have")],
            fix=fix(f"write {each.meant}", (each.name, str(each.meant)), safe=False),
        )
