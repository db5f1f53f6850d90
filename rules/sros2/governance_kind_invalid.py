"""DDS libraries cannot read a protection kind.

## What it finds
A protection kind other than NONE, SIGN, ENCRYPT, SIGN_WITH_ORIGIN_AUTHENTICATION and
ENCRYPT_WITH_ORIGIN_AUTHENTICATION. `data_protection_kind` accepts only the first three. Kinds are
case-sensitive.

## Why it matters on a robot
The library cannot parse the governance document (code 137): no participant is created and no node starts.

## Bad
```xml
<data_protection_kind>encrypt</data_protection_kind>
```

## Good
```xml
<data_protection_kind>ENCRYPT</data_protection_kind>
```

## When to ignore it
Never: the libraries refuse the whole document.

## References
- Cyclone DDS 0.10.5 with security, tested with the real library
- OMG DDS Security 1.1, clause 9.4.1.2
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="safe", symptoms=["Can not parse governance file"])
def governance_kind_invalid(robot: Robot) -> Iterator[Finding]:
    for _, remark in robot.sros2.remarks(Code.ENUM):
        if remark.detail == "default":
            continue
        right = remark.word.upper() if remark.inside.text else ""
        kinds: tuple[str, ...] = ("NONE", "SIGN", "ENCRYPT")
        if remark.detail != "data_protection_kind":
            kinds += ("SIGN_WITH_ORIGIN_AUTHENTICATION", "ENCRYPT_WITH_ORIGIN_AUTHENTICATION")
        shown = (
            f"'{remark.inside.text}' is not a valid {remark.detail}"
            if remark.inside.text
            else f"{remark.detail} is empty"
        )
        yield finding(
            remark.where,
            f"{shown}: the document cannot be parsed (code 137), no node starts",
            advice=f"write {right}" if right in kinds else f"write one of {', '.join(kinds)}",
            fix=fix(f"write {right}", (remark.where, right)) if right in kinds else None,
        )
