"""Fast DDS cannot parse the XML.

## What it finds
XML that TinyXML-2, the library's parser, refuses: end tags that do not match, an empty file, a comment before
the XML declaration, a processing instruction inside the document. A DOCTYPE that the library skips is a
warning: it never expands entities.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<!-- my robot -->
<?xml version="1.0"?>
<dds/>
```

## Good
```xml
<?xml version="1.0"?>
<!-- my robot -->
<dds/>
```

## When to ignore it
Never for an error: the library ignores the whole file. A DOCTYPE is harmless if an editor needs it.

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


@rule("error", fix="unsafe", symptoms=["XMLPARSER Error", "Error opening", "Error parsing XML buffer"])
def xml_not_wellformed(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.dds.fastdds_remarks(Code.XML, Code.INSTRUCTION):
        if not remark.fatal:
            message = "Fast DDS skips the DOCTYPE: its declarations have no effect"
            yield finding(remark.where, message, advice="delete the DOCTYPE", severity="warning")
            continue
        why = remark.xml_problem or "processing instruction"
        change = None
        span = remark.span
        if remark.xml == "late-declaration":
            start = Span(span.source, 0, 0)
            change = fix("move the declaration to the front", (span, ""), (start, f"{span.text}\n"))
        yield finding(
            remark.where,
            f"Fast DDS cannot parse the file ({why}): the whole file is ignored",
            advice="repair the XML",
            fix=change,
        )
