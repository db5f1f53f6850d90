"""No Fast DDS participant profile is the default.

## What it finds
A file with participant profiles of which none has `is_default_profile="true"`, in exactly this spelling
(`True`, `1` and `yes` have no effect). In a tree that does not mention ROS 2 the finding is information,
because programs may select a profile by its name.

## Why it matters on a robot
ROS 2 loads only the default profile. The library reads the file without an error, but none of its participant
profiles applies.

## Bad
```xml
<participant profile_name="robot" is_default_profile="True">
```

## Good
```xml
<participant profile_name="robot" is_default_profile="true">
```

## When to ignore it
If a program of your own loads the profile by its name, and the file is not meant for ROS 2 nodes.

## References
- Fast DDS 2.14.5, tested with the real library: silently accepted
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="unsafe", silent="Fast DDS uses its built-in defaults without a message")
def no_default_profile(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        participants = profiles.of_kind("participant")
        if not participants or any(profile.is_default for profile in participants) or profiles.dropped:
            continue
        if any(map(robot.dds.is_chosen_by_name, participants)):
            continue
        first = participants[0]
        change = None
        if len(participants) == 1:
            name = first.element.name.span
            behind = Span(name.source, name.end, name.end)
            change = fix("make it the default", (behind, ' is_default_profile="true"'))
            if first.default is not None:
                change = fix("make it the default", (first.default, "true"))
        yield finding(
            first.default if first.default is not None else first.element.name,
            "No participant profile is the default: ROS 2 ignores them all without a message",
            advice='write is_default_profile="true" in one of them',
            severity=None if robot.target.ros else "info",
            fix=change,
        )
