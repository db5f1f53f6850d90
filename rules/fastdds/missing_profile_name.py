"""A Fast DDS profile has no name.

## What it finds
A participant, writer, reader, topic or other profile without `profile_name`, or with an empty one.

## Why it matters on a robot
The library reports `no name found` and does not load this profile. If the file has no other profile, nothing
in it applies.

## Bad
```xml
<participant is_default_profile="true">
```

## Good
```xml
<participant profile_name="robot" is_default_profile="true">
```

## When to ignore it
Never: the library does not load the profile.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["no name found"])
def missing_profile_name(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.PROFILE_NAME):
        name = remark.word
        behind = Span(name.span.source, name.span.end, name.span.end)
        yield finding(
            name,
            f"The {name} profile has no name ('no name found'): it is not loaded",
            advice="add profile_name",
            fix=fix("add a name", (behind, ' profile_name="robot"'), safe=False),
        )
