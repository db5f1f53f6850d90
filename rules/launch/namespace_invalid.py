"""A namespace is not valid.

## What it finds
Literal node namespaces and pushed namespaces with a part that starts with a digit, with characters other than
letters, digits and underscores, or with repeated slashes.

## Why it matters on a robot
launch rejects the namespace and aborts.

## Bad
```python
PushRosNamespace('1st_robot')
```

## Good
```python
PushRosNamespace('robot_1')
```

## When to ignore it
Never: rmw rejects such a namespace in every distribution.

## References
- rmw, `rmw_validate_namespace`
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import launch
from bringup_lint.api import regex
from bringup_lint.api import rule

VALID = regex(r"/?(?:[A-Za-z_][A-Za-z0-9_]*(?:/[A-Za-z_][A-Za-z0-9_]*)*/?)?\Z")


@rule(
    "error",
    symptoms=[
        "namespace must not contain characters other than alphanumerics",
        "The resulting namespace is invalid",
        "Error while expanding or validating node name or namespace for",
    ],
)
def namespace_invalid(robot: Robot) -> Iterator[Finding]:
    for file in robot.launch.judged:
        for action, _ in robot.launch.visited(file):
            namespace = robot.launch.resolved(getattr(action, "namespace", None), file)
            text = launch.literal_text(namespace)
            if text is not None and not VALID.match(text):
                yield finding(
                    text,
                    f"Namespace '{text}' is not valid: launch aborts",
                    advice="use letters, digits and underscores, no leading digit, and single slashes",
                )
