"""A parameter has a name that nothing else has, a letter away from the one that others use.

## What it finds
A name that a launch or parameter file gives and that is in one place of the tree, while the sources of nodes declare or
ask for exactly one that is a letter away; and a name that one source declares or asks for in one place, while others
give, declare or ask for exactly one that is a letter away. Numbers and plurals are other names.

## Why it matters on a robot
rcl drops what no node declares, and the node works with the default of its source. A node that asks for a parameter
that it did not declare ends.

## Bad
```yaml
max_driving_efort: 0.4   # the node declares max_driving_effort
```

## Good
```yaml
max_driving_effort: 0.4
```

## When to ignore it
When a node that is not in the tree declares the name.

## References
- https://docs.ros.org/en/jazzy/Concepts/Basic/About-Parameters.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api import topics
from bringup_lint.api.params import undeclared
from bringup_lint.api.params import unknown_to_public
from bringup_lint.api.params import unread


@rule("warning", confidence="medium", symptoms=["ParameterNotDeclaredException"])
def name_misspelt(robot: Robot) -> Iterator[Finding]:
    misspelt = list(topics.single_parameters(robot.topics))
    told = _told(robot) if misspelt else set()
    for each in misspelt:
        if each.name.span in told:
            continue
        effect = "no node takes the value" if each.given else "the node does not get what others give"
        yield finding(
            each.name,
            f"Nothing else names the parameter '{each.name}', a letter away from '{each.meant}': {effect}",
            advice=f"write {each.meant}",
            related=[note(each.meant, "the name that others use")],
        )


def _told(robot: Robot) -> set[Span]:
    """The places of which params/not-declared speaks."""
    told = {given.place.span for found in undeclared(robot.topics) for given in found.given}
    told |= {each.key.span for group in unknown_to_public(robot.params) for each in group.parameters}
    return told | {each.key.span for group in unread(robot.params, robot.launch) for each in group.parameters}
