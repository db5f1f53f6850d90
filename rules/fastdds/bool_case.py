"""A Fast DDS boolean is neither true nor false.

## What it finds
A boolean element whose text is not exactly `true`, `false` or a number. Spaces and line ends around the word
are not allowed.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<useBuiltinTransports>False</useBuiltinTransports>
```

## Good
```xml
<useBuiltinTransports>false</useBuiltinTransports>
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
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["getXMLBool XML_ERROR!"])
def bool_case(robot: Robot) -> Iterator[Finding]:
    words = {"no": "false", "off": "false", "yes": "true", "on": "true"}
    for _, remark in robot.dds.fastdds_remarks(Code.BOOL):
        text = remark.word
        right = text.lower() if text.lower() in ("true", "false") else words.get(text.lower())
        change = None
        if right:
            change = fix(f"write {right}", (with_blanks(text), right))
        yield finding(
            text,
            f"'{text}' is not a boolean for Fast DDS, which reads only true and false: the whole file is ignored",
            advice=f"write {right}, without spaces around it" if right else "write true or false",
            fix=change,
        )
