"""Cyclone DDS does not accept a value.

## What it finds
A word, number or list that the library refuses:
- a boolean other than `true` and `false`, or an unknown word of an enumeration
- a number out of range
- a scheduling priority without a class
- an address that has to be multicast but is not
- a `${VARIABLE}` that is not closed

Values are not case-sensitive, and spaces around the text of an element do not matter.

## Why it matters on a robot
The library stops at the value and creates no participant: no ROS node starts.

## Bad
```xml
<AllowMulticast>no</AllowMulticast>
```

## Good
```xml
<AllowMulticast>false</AllowMulticast>
```

## When to ignore it
Never: the library refuses the file, and no node starts.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library: every setting with about fifty values
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import taken_by
from bringup_lint.api.cyclonedds import versions_with
from bringup_lint.api.cyclonedds import words_of
from bringup_lint.api.schema import Code


@rule(
    "error",
    fix="unsafe",
    symptoms=["undefined value", "not a decimal integer", "value out of range", "invalid value"],
)
def invalid_value(robot: Robot) -> Iterator[Finding]:
    booleans = {"no": "false", "off": "false", "0": "false", "yes": "true", "on": "true", "1": "true"}
    for _, remark in robot.dds.remarks(Code.VALUE, Code.RANGE, Code.EXPANSION, Code.PRIORITY, Code.ADDRESS):
        name = remark.known.name
        if name == "Id" or versions_with(remark):
            continue
        taken = taken_by(remark.known)
        word = booleans.get(remark.word.lower()) if "true" in words_of(remark.known) else None
        if remark.code == Code.EXPANSION:
            message = f"Cyclone DDS cannot expand '{remark.word}' ({remark.detail}): no node starts"
        elif remark.code == Code.PRIORITY:
            message = f"Priority {remark.word} without a Class aborts the process: no node starts"
            taken = "add <Class>realtime</Class>, or delete the priority"
        elif remark.code == Code.ADDRESS:
            message = f"{name} '{remark.word}' is not a multicast address: no node starts"
            taken = "write an address of 224.0.0.0/4"
        elif remark.code == Code.RANGE:
            message = f"{name} '{remark.word}' is out of range: no node starts"
        else:
            message = f"{name} '{remark.word}' is not a value that Cyclone DDS accepts: no node starts"
        yield finding(
            remark.word,
            message,
            advice=f"write {word}" if word else taken,
            fix=fix(f"write {word}", (remark.word, word), safe=False) if word else None,
        )
