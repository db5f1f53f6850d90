"""A security document was changed but not signed again.

## What it finds
A governance or permissions document whose text differs from the one inside the signed file beside it. Spaces
and line ends are ignored. It is an info where both allow the same: only the order of the topics is another one, or a
pattern of their list covers what is new.

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
from fnmatch import fnmatchcase
from re import Match

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule

MOST = 100_000
"""Names times patterns that are compared."""
LIST = regex(r"<topics>(?:<topic>[^<]{1,300}</topic>){1,5000}</topics>", hints="<topics>")
NAME = regex(r"<topic>([^<]{1,300})</topic>", hints="<topic>")


@rule("warning", symptoms=["digest failure"])
def permissions_unsigned_newer(robot: Robot) -> Iterator[Finding]:
    for document in robot.sros2.documents:
        signed = robot.sros2.signed_text(document.source)
        if signed is None:
            continue
        mine, theirs = _squeezed(document.source.text), _squeezed(signed[1])
        if mine == theirs:
            continue
        same = _reduced(mine) == _reduced(theirs)
        then = f"the rules in {signed[0].basename} allow the same"
        yield finding(
            document.source,
            f"{document.source.basename} was changed but not signed again: "
            + (then if same else f"the robot still uses the rules in {signed[0].basename}"),
            advice="sign the document again (ros2 security create_permission, or openssl smime -sign)",
            related=[note(signed[0], "the signed text differs")],
            severity="info" if same else None,
        )


def _squeezed(text: str) -> str:
    start = text.find("<dds")
    return "".join(text[max(start, 0) : text.rfind(">") + 1].split())


def _reduced(squeezed: str) -> str:
    """A document in which each list of topics is in order, and without what a pattern of the list covers."""
    return LIST.sub(_needed, squeezed)


def _needed(match: Match[str]) -> str:
    names = sorted(set(NAME.findall(match[0])))
    patterns = [name for name in names if "*" in name]
    few = patterns if len(names) * len(patterns) <= MOST else ()
    covered = {name for name in names for each in few if each != name and fnmatchcase(name, each)}
    return "".join(f"<topic>{name}</topic>" for name in names if name not in covered)
