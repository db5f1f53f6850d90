"""DDS libraries cannot read a validity date.

## What it finds
A `not_before` or `not_after` that is not `YYYY-MM-DDThh:mm:ss`, with or without `Z` or an offset.

## Why it matters on a robot
The library reads a date without a time as expired (code 147): the participant is rejected and the node does
not start.

## Bad
```xml
<not_after>2036-11-17</not_after>
```

## Good
```xml
<not_after>2036-11-17T00:00:00</not_after>
```

## When to ignore it
Never: the library cannot read the date.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.3
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["Permissions validity period expired"])
def permissions_date_format(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.sros2.remarks(Code.DATE):
        text = remark.inside.text
        short = re.fullmatch(r"\d{4}-\d\d-\d\d", text)
        yield finding(
            remark.where,
            f"'{text}' is not a date with a time: it is read as expired, the node does not start",
            advice=f"write {text}T00:00:00, and sign the document again" if short else "write YYYY-MM-DDThh:mm:ss",
            fix=fix("add the time", (remark.where, f"{text}T00:00:00")) if short else None,
        )
