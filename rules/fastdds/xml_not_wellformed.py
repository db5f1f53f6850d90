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
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import Source
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.schema import Code
from bringup_lint.api.schema import Remark

MOST = 5
"""As many further places as a reader looks at: what is after the first error is often its consequence."""


@rule("error", fix="unsafe", symptoms=["XMLPARSER Error", "Error opening '*.xml'", "Error parsing XML buffer"])
def xml_not_wellformed(robot: Robot) -> Iterator[Finding]:
    fatal: dict[Source, list[Remark]] = {}
    for profiles, remark in robot.dds.fastdds_remarks(Code.XML, Code.INSTRUCTION):
        if remark.fatal:
            fatal.setdefault(profiles.source, []).append(remark)
        else:
            message = "Fast DDS skips the DOCTYPE: its declarations have no effect"
            yield finding(remark.where, message, advice="delete the DOCTYPE", severity="warning")
    for first, *others in fatal.values():
        yield finding(
            first.where,
            f"Fast DDS cannot parse the file ({problem(first)}): the whole file is ignored",
            advice="repair the XML",
            related=[note(each.where, problem(each)) for each in others[:MOST]],
            fix=moved(first.span) if first.xml == "late-declaration" else None,
        )


def problem(remark: Remark) -> str:
    return remark.xml_problem or "processing instruction"


def moved(declaration: Span) -> Fix:
    start = Span(declaration.source, 0, 0)
    return fix("move the declaration to the front", (declaration, ""), (start, f"{declaration.text}\n"))
