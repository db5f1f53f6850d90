"""The root element of a Fast DDS file is not dds or profiles.

## What it finds
A root other than `dds`, `profiles`, `types`, `log` or `library_settings`, in exactly this case. The
namespace does not matter.

## Why it matters on a robot
The library ignores the whole file and goes on with its defaults, exit status 0: multicast discovery, no
peers, no limits. Only a line on the terminal tells.

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


@rule("error", fix="safe", symptoms=["Not found root tag"])
def wrong_root(robot: Robot) -> Iterator[Finding]:
    for profiles, _ in robot.dds.fastdds_remarks(Code.ROOT):
        root = profiles.document.root
        right = root.name.lower() if root.name.lower() in ("dds", "profiles") else None
        yield finding(
            root.name,
            f"The root element '{root.name}' is unknown to Fast DDS: the whole file is ignored",
            advice=f"write {right}" if right else "make dds the outermost element, with profiles inside",
            fix=fix(f"rename to {right}", *robot.dds.renamed(root.name, right)) if right else None,
        )
