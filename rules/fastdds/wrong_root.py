"""The root element of a Fast DDS file is not dds or profiles.

## What it finds
A root element other than `dds`, `profiles`, `types`, `log` or `library_settings`. Names are case-sensitive.
The namespace does not matter.

## Why it matters on a robot
The library ignores the whole file and uses its defaults: multicast discovery, no peers, no limits. The exit
status is 0, and only a line on the terminal reports the error.

## Bad
```xml
<DDS>
  <profiles/>
</DDS>
```

## Good
```xml
<dds>
  <profiles/>
</dds>
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
from bringup_lint.api.dds import renamed
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["Not found root tag"])
def wrong_root(robot: Robot) -> Iterator[Finding]:
    for profiles, _ in robot.dds.fastdds_remarks(Code.ROOT):
        root = profiles.document.root
        assert root is not None
        right = root.name.lower() if root.name.lower() in ("dds", "profiles") else None
        yield finding(
            root.name,
            f"Fast DDS does not know the root element '{root.name}': the whole file is ignored",
            advice=f"write {right}" if right else "make dds the outermost element, with profiles inside",
            fix=fix(f"rename to {right}", *renamed(root.name, right)) if right else None,
        )
