"""Fast DDS does not know a word.

## What it finds
An enumeration whose text is not exactly one of the library's words. The words are case-sensitive, and spaces
around them are not allowed.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<kind>reliable</kind>
```

## Good
```xml
<kind>RELIABLE</kind>
```

## When to ignore it
Never: the library ignores the whole file.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.fastdds import with_blanks
from bringup_lint.api.fastdds import words_taken
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["bad content", "Invalid transport type"])
def enum_case(robot: Robot) -> Iterator[Finding]:
    for profiles, remark in robot.dds.fastdds_remarks(Code.ENUM):
        text = remark.word
        known = words_taken(profiles, remark)
        right = next((word for word in known if word.lower() == text.lower()), None)
        change = fix(f"write {right}", (with_blanks(text), right)) if right else None
        blanks = text != with_blanks(text).text
        says = (
            f"'{text}' has spaces around it"
            if blanks and right == text
            else f"'{text}' is not a value that Fast DDS accepts here"
        )
        yield finding(
            text,
            f"{says}: the whole file is ignored, the robot runs with defaults",
            advice=f"write {right}" if right else f"write one of {', '.join(known)}",
            fix=change,
        )
