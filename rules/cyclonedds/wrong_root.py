"""The root element of a Cyclone DDS file is not CycloneDDS.

## What it finds
A file whose outermost element is not `CycloneDDS` (in any case). Only XML that is given inline in
`CYCLONEDDS_URI` may omit it.

## Why it matters on a robot
The library does not know the element and creates no participant: no ROS node starts.

## Bad
```xml
<Cyclone>
  <Domain/>
</Cyclone>
```

## Good
```xml
<CycloneDDS>
  <Domain/>
</CycloneDDS>
```

## When to ignore it
Never: the library refuses the file, and no node starts.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import Span
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.schema import Code


@rule("error", fix="unsafe", symptoms=["unknown element"])
def wrong_root(robot: Robot) -> Iterator[Finding]:
    for configuration, _remark in robot.dds.remarks(Code.ROOT):
        root = configuration.document.root
        assert root is not None
        start = root.name.span
        end = root.span
        closing = Span(end.source, end.end - len(root.name) - 1, end.end - 1)
        change = None
        if closing.text == root.name and root.name.lower() not in ("general", "discovery", "domain"):
            change = fix("rename the root element", (start, "CycloneDDS"), (closing, "CycloneDDS"), safe=False)
        yield finding(
            root.name,
            f"Cyclone DDS does not know the root element '{root.name}': no participant can be created, no node starts",
            advice="make CycloneDDS the outermost element, with Domain inside",
            fix=change,
        )
