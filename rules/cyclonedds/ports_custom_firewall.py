"""The firewall blocks the ports that Cyclone DDS uses.

## What it finds
Settings under `Discovery/Ports` of a Cyclone DDS file that move the ports, and a firewall of the tree that
opens UDP ports for DDS, but not those of the first participant. The domain of the processes that read the
file has to be known.

## Why it matters on a robot
Other machines do not see the robot. On the robot itself everything works.

## Bad
```xml
<Ports><Base>7600</Base></Ports>   <!-- the firewall opens 17900:18000/udp for domain 42 -->
```

## Good
```xml
<Ports><Base>7400</Base></Ports>
```

## When to ignore it
If DDS only has to work on the robot itself, and the open ports are for something else.

## References
- DDSI-RTPS 2.5, section 9.6.2.3
- Cyclone DDS, configuration reference: Domain/Discovery/Ports
"""

from collections.abc import Iterator
from itertools import islice

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import PORT_DEFAULTS
from bringup_lint.api.cyclonedds import Setting

MOST = 5
"""Firewalls that are compared with one configuration."""


@rule("warning", symptoms=["[UFW BLOCK] * PROTO=UDP"])
def ports_custom_firewall(robot: Robot) -> Iterator[Finding]:
    for configuration, domain in robot.dds.domains:
        settings = [(name, domain.get(f"Discovery/Ports/{name}")) for name in PORT_DEFAULTS]
        given = {name: setting for name, setting in settings if setting is not None}
        numbers = {reader.domain for reader in robot.dds.readers(configuration)}
        number = numbers.pop() if len(numbers) == 1 else None
        needed = _ports(given, number) if number is not None else []
        if not needed:
            continue
        for firewall in islice(robot.firewalls, MOST):
            uncertain = any(not each.certain and each.protocol != "tcp" for each in firewall.openings)
            opened = [each for each in firewall.udp if each.first >= 1024]
            closed = [port for port in needed if not any(each.first <= port <= each.last for each in firewall.udp)]
            if opened and closed and not firewall.opens_all and not uncertain:
                yield finding(
                    next(iter(given.values())).value,
                    f"DDS uses the ports {', '.join(map(str, needed))}, but the firewall blocks {closed[0]}: "
                    "other machines see nothing of the robot",
                    advice="open these ports, or use the default ones",
                    related=[note(opened[0].where, "the firewall opens these")],
                )


def _ports(given: dict[str, Setting], number: int) -> list[int]:
    """The ports of a domain; empty for the usual ones, and where a setting is not known."""
    texts = {name: (setting.effective or "").strip() for name, setting in given.items()}
    if not all(text.isdecimal() for text in texts.values()):
        return []
    values = PORT_DEFAULTS | {name: int(text) for name, text in texts.items()}
    base = values["Base"] + values["DomainGain"] * number
    offsets = {values[name] for name in PORT_DEFAULTS if name.endswith("Offset")}
    return sorted(base + offset for offset in offsets) if values != PORT_DEFAULTS else []
