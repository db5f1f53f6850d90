"""Security updates are not installed automatically.

## What it finds
`Unattended-Upgrade::Allowed-Origins` (or `Origins-Pattern`) without the security pocket, in a file where no other
block lists it.

## Why it matters on a robot
unattended-upgrades runs every day but skips the security updates, the main reason to set it up.

## Bad
```
Unattended-Upgrade::Allowed-Origins {
  "${distro_id}:${distro_codename}";
};
```

## Good
```
Unattended-Upgrade::Allowed-Origins {
  "${distro_id}:${distro_codename}-security";
};
```

## When to ignore it
When another file of apt.conf.d, which is not in the tree, adds the security origin.

## References
- unattended-upgrades, README
- robotics-security guide
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import regex
from bringup_lint.api import rule

BLOCK = regex(
    r"^[ \t]*Unattended-Upgrade::(?:Allowed-Origins|Origins-Pattern)[ \t]*"
    r'\{((?:"[^"\n]*"|[^{}"])*)\}',
    re.M,
)
COMMENT = regex(r"(?://|#)[^\n]*|/\*.*?(?:\*/|\Z)", re.S)


@rule("info", silent="unattended-upgrades finds nothing to install, which is not an error")
def apt_no_security_origin(robot: Robot) -> Iterator[Finding]:
    for source in robot.of_kind("apt-conf"):
        blocks = list(BLOCK.finditer(source.text))
        if blocks and not any("security" in COMMENT.sub("", match[1]).lower() for match in blocks):
            yield finding(
                source.span(blocks[0].start(), blocks[0].start() + len(blocks[0][0].split("{")[0].rstrip())),
                "None of these origins is the security pocket: its updates are not installed",
                advice='add "${distro_id}:${distro_codename}-security";',
            )
