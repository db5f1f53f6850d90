"""A Cyclone DDS peer has no address.

## What it finds
A `Peer` without the attribute `Address`, or with the address as text. The attribute name is not
case-sensitive. An empty address is a warning: the library accepts it and contacts no machine.

## Why it matters on a robot
The library reports `element missing in configuration` or `no data expected` and creates no participant: no
ROS node starts.

## Bad
```xml
<Peer>10.0.0.10</Peer>
```

## Good
```xml
<Peer Address="10.0.0.10"/>
```

## When to ignore it
Never: the library refuses the file, and no node starts. An empty address does no harm, but has no effect.

## References
- Cyclone DDS 0.10.5 and 11.0.1, tested with the real library
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import rule
from bringup_lint.api.addresses import is_address
from bringup_lint.api.xml import Element


@rule("error", fix="safe", symptoms=["element missing in configuration", "no data expected"])
def peer_missing_address(robot: Robot) -> Iterator[Finding]:
    for _, domain in robot.dds.domains:
        for element in domain.found("Discovery/Peers/Peer"):
            address = domain.of(element, "Address")
            if address is not None and address.effective == "":
                message = "The peer's address is empty: no machine is contacted"
                yield finding(element.name, message, advice="write the address, or delete the peer", severity="warning")
            elif address is None or element.text:
                change = None
                if address is None and is_address(element.text) and _is_bare(element):
                    change = fix("make it an attribute", (element.span, f'<{element.name} Address="{element.text}"/>'))
                yield finding(
                    element.name,
                    "A Peer needs the attribute Address and accepts no text: no participant can be created, "
                    "no node starts",
                    advice='write <Peer Address="..."/>',
                    fix=change,
                )


def _is_bare(element: Element) -> bool:
    """Whether nothing but text is in an element: attributes and comments would be lost."""
    return not element.children and not element.attributes and "<!--" not in element.span.text
