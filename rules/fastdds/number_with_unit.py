"""A Fast DDS number with something behind it.

## What it finds
A number element with text behind the digits, which is cut off without a word, or one that does not
begin with a number or is out of range.

## Why it matters on a robot
`4MB` is read as 4 bytes: the participant cannot be created, or every message is cut into pieces. A text
that is no number drops the whole file.

## Bad
```xml
<receiveBufferSize>4MB</receiveBufferSize>
```

## Good
```xml
<receiveBufferSize>4194304</receiveBufferSize>
```

## References
- Fast DDS 2.14.5, tried with the real library
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
        text = remark.where
        name = remark.path.rpartition("/")[2]
        if remark.fatal:
            why = f" ({remark.detail})" if remark.detail else ""
            message = f"{name} '{text}' is not a number that Fast DDS takes{why}: the whole file is ignored"
            yield finding(text, message, advice="write a plain number")
            continue
        digits = text[: len(text) - len(remark.detail)].strip()
        factor = sizes.get(remark.detail.lower())
        value = str(int(digits) * factor) if factor and digits.isdigit() else None
        yield finding(
            text,
            f"{name} '{text}' is read as {digits}: the rest is cut off",
            advice=f"write {value}" if value else "write a plain number",
            fix=fix(f"write {value}", (text, value), safe=False) if value else None,
        )
