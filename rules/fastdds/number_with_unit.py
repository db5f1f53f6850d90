"""A Fast DDS number is followed by other text.

## What it finds
A number element with text after the digits, which the library ignores without a message. A number that is out
of range, or text that does not start with a number.

## Why it matters on a robot
The library reads `4MB` as 4 bytes: the participant cannot be created, or every message is split into pieces.
If the text is not a number, the library ignores the whole file.

## Bad
```xml
<receiveBufferSize>4MB</receiveBufferSize>
```

## Good
```xml
<receiveBufferSize>4194304</receiveBufferSize>
```

## When to ignore it
Never: the library does not know units.

## References
- Fast DDS 2.14.5, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule(
    "error",
    fix="unsafe",
    symptoms=[
        "maxMessageSize cannot be greater than receiveBufferSize",
        "getXMLUint XML_ERROR!",
        "getXMLInt XML_ERROR!",
    ],
)
def number_with_unit(robot: Robot) -> Iterator[Finding]:
    sizes = {"k": 1 << 10, "kb": 1 << 10, "kib": 1 << 10, "m": 1 << 20, "mb": 1 << 20, "mib": 1 << 20, "b": 1}
    for _, remark in robot.dds.fastdds_remarks(Code.NUMBER):
        text = remark.word
        name = remark.path.rpartition("/")[2]
        if remark.fatal:
            why = f" ({remark.detail})" if remark.detail else ""
            message = f"{name} '{text}' is not a number that Fast DDS accepts{why}: the whole file is ignored"
            yield finding(text, message, advice="write a plain number")
            continue
        digits = text[: len(text) - len(remark.detail)].strip()
        factor = sizes.get(remark.detail.lower())
        value = str(int(digits) * factor) if factor and digits.isdecimal() else None
        yield finding(
            text,
            f"{name} '{text}' is read as {digits}: the library ignores the rest",
            advice=f"write {value}" if value else "write a plain number",
            fix=fix(f"write {value}", (text, value), safe=False) if value else None,
        )
