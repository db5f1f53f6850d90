"""ROS_SECURITY_STRATEGY is neither Enforce nor Permissive.

## What it finds
A value other than `Enforce` and `Permissive`. Upper and lower case matter.

## Why it matters on a robot
rcl treats everything but `Enforce` as permissive: a node without credentials runs unsecured instead of failing.

## Bad
```sh
ROS_SECURITY_STRATEGY=enforce
```

## Good
```sh
ROS_SECURITY_STRATEGY=Enforce
```

## When to ignore it
When Permissive is intended. Writing `Permissive` says so.

## References
- rcl, `security.c`: the values are compared letter by letter
- https://docs.ros.org/en/rolling/Tutorials/Advanced/Security/The-Keystore.html
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule

WORDS = ("Enforce", "Permissive")


@rule("error", fix="unsafe", symptoms=["SECURITY ERROR: directory '*' does not exist., at"], tags=["CWE-1188"])
def ros_security_strategy_invalid(robot: Robot) -> Iterator[Finding]:
    for setting in robot.ros.of("ROS_SECURITY_STRATEGY"):
        if setting.text in ("", *WORDS):
            continue
        meant = next((word for word in WORDS if word.lower() == setting.text.lower()), None)
        yield finding(
            setting.value,
            f"ROS_SECURITY_STRATEGY '{setting.text}' means permissive: a node without credentials runs unsecured",
            advice=f"write {meant or 'Enforce'}",
            fix=fix(f"write {meant}", (setting.value, meant)) if meant else None,
        )
