"""A comment hides a Fast DDS value.

## What it finds
A comment inside an element, before its text. The library's XML parser returns the text only if it comes
first.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<participantID><!-- the base -->5</participantID>
```

## Good
```xml
<!-- the base -->
<participantID>5</participantID>
```

## When to ignore it
Never: the library ignores the whole file.

## References
- Fast DDS 2.14.5, tested with the real library; TinyXML-2, XMLElement::GetText
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", symptoms=["XML_ERROR!", "elements cannot be empty"])
def hidden_text(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.COMMENT):
        yield finding(
            remark.where,
            f"The comment before it hides the value of {remark.detail}: the whole file is ignored",
            advice="move the comment out of the element",
        )
