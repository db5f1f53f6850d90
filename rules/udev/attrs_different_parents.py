r"""The parent keys of one rule refer to different devices.

## What it finds
`KERNELS`, `SUBSYSTEMS`, `DRIVERS` and `ATTRS` keys of one rule that belong to different devices of the chain.
All of them must match one and the same device:
- The USB device (`1-1.2`) has vendor, product and serial number.
- Its interface (`1-1.2:1.0`) has the interface number and a driver such as uvcvideo or ftdi_sio.
- The tty or video node is another device again.

## Why it matters on a robot
The rule never fires: no link, no permissions. `udevadm verify` finds nothing wrong, because each key is valid
on its own.

## Bad
```udev
SUBSYSTEM=="video4linux", ATTRS{idVendor}=="0c45", ATTRS{idProduct}=="6366", KERNELS=="1-1.2:1.0", \
  ATTR{index}=="0", SYMLINK+="robot/camera_front"
```

## Good
```udev
SUBSYSTEM=="video4linux", ATTRS{idVendor}=="0c45", ATTRS{idProduct}=="6366", KERNELS=="1-1.2", \
  ATTR{index}=="0", SYMLINK+="robot/camera_front"
```

## When to ignore it
Never: udev compares all parent keys of a line with one device at a time, so this combination cannot match.

## References
- udev(7), KERNELS and ATTRS: "all have to match at the same device"
- https://github.com/systemd/systemd/issues/43405
"""

import re
from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Fix
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.udev import Token
from bringup_lint.api.udev import UdevRule

_PLACE = {
    "usb_device": "the USB device",
    "usb_interface": "a USB interface",
    "usb-serial": "the port below the interface",
}
_INTERFACE = regex(r"(?<!\d)(\d+-[\d.]+):\d+\.\d+")


@rule("error", fix="unsafe", silent="a match that fails is not reported")
def attrs_different_parents(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        if line.impossible_parents is None:
            continue
        first, second = line.impossible_parents
        interface = next((token for token in (second, first) if _is_interface(token)), None)
        owners = f"{_named(first)} belongs to {_owner(line, first)}, {_named(second)} to {_owner(line, second)}"
        yield finding(
            interface.value if interface else second.span,
            f"The rule never fires: {owners}",
            advice=_advice(interface),
            related=[note((first if interface is not first else second).span, "this key has to match the same device")],
            fix=_fix(interface, first if interface is not first else second, line),
        )


def _is_interface(token: Token) -> bool:
    return token.key == "KERNELS" and _INTERFACE.fullmatch(token.value) is not None


def _named(token: Token) -> str:
    return token.name if token.key == "ATTRS" else f"{token.name} '{token.value}'"


def _owner(line: UdevRule, token: Token) -> str:
    found = sorted(line.levels(token) - {"other"})
    named = [_PLACE.get(name, f"a {name} device") for name in found]
    return " or ".join(named)


def _advice(interface: Token | None) -> str:
    if interface is not None:
        device = _INTERFACE.sub(_device, interface.value)
        return f'write KERNELS=="{device}", or match the port with ENV{{ID_PATH}}'
    return "keep the parent keys of one device, and match the others with ENV{ID_...}, ATTR or KERNEL"


def _device(found: re.Match[str]) -> str:
    return found[1]


def _fix(interface: Token | None, other: Token, line: UdevRule) -> Fix | None:
    if interface is None or line.levels(other) - {"other"} != {"usb_device"}:
        return None
    return fix("name the USB device", (interface.value, _INTERFACE.sub(_device, interface.value)))
