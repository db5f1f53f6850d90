"""A security document was changed but not signed again.

## What it finds
A governance or permissions document whose text differs from the one inside the signed file beside it. Spaces
and line ends are ignored.

## Why it matters on a robot
The robot reads only the signed file: the change has no effect, and the old rules stay in force.

## Bad
```text
permissions.xml   grants rt/odom and rt/map
permissions.p7s   grants rt/odom
```

## Good
```text
permissions.xml   grants rt/odom
permissions.p7s   grants rt/odom
```

## When to ignore it
If the documents in the tree are only sources, and the build signs them before they are deployed.

## References
- Cyclone DDS 0.10.5 with security: a signed file that is changed gives a digest failure (code 127)
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", symptoms=["digest failure"])
def permissions_unsigned_newer(robot: Robot) -> Iterator[Finding]:
    for document in robot.sros2.documents:
        signed = robot.sros2.signed_text(document.source)
        if signed is None or _squeezed(document.source.text) == _squeezed(signed[1]):
            continue
        yield finding(
            document.source,
            f"{document.source.basename} was changed but not signed again: the robot still uses the rules in "
            f"{signed[0].basename}",
            advice="sign the document again (ros2 security create_permission, or openssl smime -sign)",
            related=[note(signed[0], "the signed text differs")],
        )


def _squeezed(text: str) -> str:
    start = text.find("<dds")
    return "".join(text[max(start, 0) : text.rfind(">") + 1].split())
