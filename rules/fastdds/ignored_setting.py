"""A Fast DDS setting has no effect.

## What it finds
Settings that the library does not use:
- QoS that it knows by name but does not support in XML: `durabilityService`, `presentation`,
  `timeBasedFilter`, `destinationOrder`
- the tags `qos_profile`, `application` and `type` below `profiles`
- settings of a transport that its type does not read, such as `segment_size` for UDPv4

## Why it matters on a robot
The setting has no effect. For unsupported QoS and tags the library also logs an error at every start.

## Bad
```xml
<presentation>
  <access_scope>TOPIC</access_scope>
</presentation>
```

## Good
```xml
<!-- set it in the program -->
```

## When to ignore it
If the file is shared with a DDS tool that does read the setting.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterable
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Located
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.fastdds import transport_type
from bringup_lint.api.schema import Code


@rule("warning", symptoms=["do not supported for now"])
def ignored_setting(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.IGNORED):
        yield finding(
            remark.word,
            f"{remark.word} is not supported in XML: it has no effect, and every start logs an error",
            advice="delete it",
        )
    for words in passed_over(robot):
        first, *others = words
        also = f" (nor {len(others)} more)" if others else ""
        yield finding(
            first,
            f"A {transport_type(first)} transport does not read {first}{also}: it has no effect",
            advice="delete it, or choose another type",
            related=[note(word, "not read either") for word in others],
        )


def passed_over(robot: Robot) -> Iterable[list[Located]]:
    """The settings that a transport does not read, for each transport."""
    found: dict[tuple[Source, int], list[Located]] = {}
    for profiles, remark in robot.dds.fastdds_remarks(Code.PASSED_OVER):
        transport = profiles.source.text.rfind("<transport_descriptor>", 0, remark.span.start)
        found.setdefault((profiles.source, transport), []).append(remark.word)
    return found.values()
