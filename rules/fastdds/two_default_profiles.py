"""Two Fast DDS profiles are marked as the default.

## What it finds
More than one participant, writer, reader or topic profile of one file with `is_default_profile="true"`.

## Why it matters on a robot
The library uses only one of them, and no message says which.

## Bad
```xml
<participant profile_name="a" is_default_profile="true"/>
<participant profile_name="b" is_default_profile="true"/>
```

## Good
```xml
<participant profile_name="a" is_default_profile="true"/>
<participant profile_name="b"/>
```

## When to ignore it
Never: which profile applies is not documented. Keep the mark on the one that you want.

## References
- Fast DDS 2.14.5, tested with the real library: accepted silently
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule


@rule("warning", silent="Fast DDS uses one of them without a message")
def two_default_profiles(robot: Robot) -> Iterator[Finding]:
    for profiles in robot.dds.profile_files:
        for kind in ("participant", "data_writer", "data_reader", "topic"):
            marks = [each.default for each in profiles.of_kind(kind) if each.is_default and each.default is not None]
            if len(marks) > 1:
                first, second, *others = marks
                yield finding(
                    second,
                    f"{'Two' if not others else len(marks)} {kind} profiles are the default: "
                    "only one is used, and no message says which",
                    advice="keep one",
                    related=[note(first, "the first one")] + [note(other, "another one") for other in others],
                )
