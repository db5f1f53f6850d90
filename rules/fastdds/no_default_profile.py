"""No Fast DDS participant profile is the default.

## What it finds
A file with participant profiles of which none has `is_default_profile="true"`, in exactly this spelling
(`True`, `1` and `yes` select nothing). In a tree that does not mention ROS 2 the finding is for
information: programs may choose a profile by its name.

## Why it matters on a robot
ROS 2 loads the default profile only. The file is read without any error, and nothing of its
participants counts.

## Bad
```xml
<participant profile_name="robot" is_default_profile="True">
```

## Good
```xml
<participant profile_name="robot" is_default_profile="true">
```

## References
- Fast DDS 2.14.5, tried with the real library: silently accepted
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule


@rule("error", fix="safe")
def no_default_profile(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        participants = profiles.of_kind("participant")
        if not participants or any(profile.is_default for profile in participants) or profiles.dropped:
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
            "No participant profile is the default: ROS 2 ignores them all, without a word",
            advice='write is_default_profile="true" in one of them',
            severity=None if robot.target.ros else "info",
            fix=change,
        )
