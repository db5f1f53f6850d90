"""DDS is bound to one network adapter by its hardware address.

## What it finds
A Cyclone DDS configuration whose only interface has the name of one adapter: `enx` and the twelve digits of its MAC
address, as udev calls adapters on USB. Silent where netplan, NetworkManager, networkd or udev of the tree speak of the
same adapter, where a condition of a script asks for it, and for a whole root file system, which is that of one robot.
Info where a program of the tree writes this file with its interface, and does not name the adapter itself: it is given
the interface on each machine.

## Why it matters on a robot
Each adapter has another name. After the adapter is replaced, on the next robot, and in the container that runs on the
robot instead of the laptop, the interface does not exist: Cyclone DDS creates no participant, and no node starts.

## Bad
```xml
<NetworkInterface name="enx00155d4f2a10"/>
```

## Good
```xml
<NetworkInterface address="192.168.123.99"/>
```

## When to ignore it
When there is one robot, and its adapter stays.

## References
- systemd.net-naming-scheme(7): enx with the MAC address
- https://cyclonedds.io/docs/cyclonedds/latest/config/config_file_reference.html, NetworkInterface
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.cyclonedds import Setting
from bringup_lint.api.dds import named_interfaces

ADAPTER = regex(r"enx[0-9a-f]{12}$")
PROGRAM = regex(r"\.(?:py|sh|bash)$|(?:^|/)(?:Makefile|[Jj]ustfile)$")
MOST = 100_000
"""Characters of a program that are read."""
REDIRECTS = r"(?<![-=/\"\w])>|\btee\b|\bsed[ \t]+-\w{0,5}i(?:(?!;[ \t]|&&)[^\n]){1,120}[ \t]"
"""What precedes the name of a file that a shell writes."""
NETWORK = ("netplan", "cloud-init-network", "networkd", "networkmanager", "udev-rules")


@rule("warning", confidence="medium", symptoms=["does not match an available interface"])
def interface_of_one_adapter(robot: Robot) -> Iterator[Finding]:
    by_name: dict[str, list[Setting]] = {}
    for configuration, domain in robot.dds.domains:
        names = list(named_interfaces(domain))
        needed = [each for each in names if domain.of(each.owner, "presence_required") is None]
        if all(ADAPTER.match(str(each.effective)) for each in names) and robot.dds.plan_of(configuration) is None:
            for setting in needed[:1]:
                by_name.setdefault(str(setting.effective), []).append(setting)
    for name, (first, *others) in by_name.items():
        if robot.tree.complete or _is_spoken_of(robot, name):
            continue
        yield finding(
            first.value,
            f"{name} is the name of one network adapter: with another one, or on another robot, no node starts",
            advice="give address= and the fixed address of the robot, or name the adapter in a .link file",
            related=[note(each.value, "here, too") for each in others],
            chain=robot.provenance.chain_to(first.value, f"DDS uses {name}"),
            severity="info" if _is_written_anew(robot, first.value.span.source.basename, name) else None,
        )


def _is_written_anew(robot: Robot, file: str, adapter: str) -> bool:
    """Whether a program of the tree writes the file with another interface: what is checked in is what it once
    wrote."""
    texts = (text for text in robot.tree.pages(PROGRAM, MOST) if file in text and "NetworkInterface" in text)
    return any(_writes(text, file) for text in texts if adapter not in text)


def _writes(text: str, file: str) -> bool:
    """Whether a program opens a file for writing, by its name or by the variable that holds it."""
    name = re.escape(file)
    held = re.findall(rf"^[ \t]*(?:export[ \t]+)?(\w+)[ \t]*=[^\n]{{0,120}}\b{name}\b", text, re.M)
    called = "|".join([rf"[\w./$\{{}}~-]*\b{name}\b", *(rf"\$?\{{?{variable}\b\}}?" for variable in held)])
    return (
        re.search(
            rf"\bopen\([^()\n]{{0,80}}(?<!\w)(?:{called})[\"']?,[ \t]*(?:mode=)?[\"']w"
            rf"|(?<!\w)(?:{called})[\"']?\)?\.write_text\("
            rf"|(?:{REDIRECTS})[ \t]*[\"']?(?:{called})(?![\w.])",
            text,
        )
        is not None
    )


def _is_spoken_of(robot: Robot, name: str) -> bool:
    """Whether the tree configures the adapter, or asks whether it is there."""
    if any(name in source.text for source in robot.of_kind(*NETWORK)):
        return True
    asked = re.compile(rf"(?:\bif\b|\[|&&|\|\|)[^\n]{{0,200}}\b{re.escape(name)}\b")
    return robot.mentions(asked)
