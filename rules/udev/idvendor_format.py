"""A USB vendor or product id is not written as in sysfs.

## What it finds
`idVendor` or `idProduct` (also `ID_VENDOR_ID`, `ID_MODEL_ID`) that is not exactly four lower-case hexadecimal
digits, or the swapped numbers of a known device.

## Why it matters on a robot
udev compares text: `10C4`, `0x10c4` and `403` do not match `10c4` and `0403`. The rule never fires.

## Bad
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="10C4", ATTRS{idProduct}=="0xea60", SYMLINK+="robot/lidar"
```

## Good
```udev
SUBSYSTEM=="tty", ATTRS{idVendor}=="10c4", ATTRS{idProduct}=="ea60", SYMLINK+="robot/lidar"
```

## When to ignore it
Never: sysfs always shows four lower-case digits, and udev compares them as text.

## References
- udev(7), ATTRS
- Linux ABI documentation, sysfs-bus-usb: idVendor
"""

from collections.abc import Iterator

from bringup_lint.api import Finding
from bringup_lint.api import Robot
from bringup_lint.api import finding
from bringup_lint.api import fix
from bringup_lint.api import note
from bringup_lint.api import regex
from bringup_lint.api import rule
from bringup_lint.api.udev import Token

_KEYS = {
    "ATTR": ("idVendor", "idProduct"),
    "ATTRS": ("idVendor", "idProduct"),
    "ENV": ("ID_VENDOR_ID", "ID_MODEL_ID"),
}
HUB = "1d6b"
OF_HUB = "match the ids of the device itself: 1d6b is the root hub, above every device of the computer's port"
_NUMBER = regex(r"(?:0[xX])?([0-9a-fA-F]{1,4})")


@rule("error", fix="unsafe", silent="a match that fails is not reported")
def idvendor_format(robot: Robot) -> Iterator[Finding]:
    for line in robot.udev.judged:
        for token in line.line.tokens:
            known = token.attribute in _KEYS.get(token.key, ()) and not line.is_for("pci", "net", "sound", "block")
            if known and token.is_match and "i" not in token.prefix:
                yield from _numbers(token)
        if line.swapped_usb_id is not None:
            vendor, product = line.swapped_usb_id
            yield finding(
                vendor.value,
                f"idVendor {vendor.value} and idProduct {product.value} are swapped: the rule never fires",
                advice=OF_HUB
                if product.value == HUB
                else f'write idVendor=="{product.value}" and idProduct=="{vendor.value}"',
                related=[note(product.value, "this is the number of the vendor")],
            )


def _numbers(token: Token) -> Iterator[Finding]:
    if token.has_substitution or any(character in token.value for character in "*?[\\"):
        return
    at = 0
    for number in token.value.split("|"):
        found = _NUMBER.fullmatch(number)
        right = found[1].lower().rjust(4, "0") if found else ""
        if number and right != number:
            where = token.value.part(at, at + len(number))
            stored = f"'{right}'" if right else "four lower-case hexadecimal digits"
            yield finding(
                where,
                f"{token.attribute} '{number}' never matches: sysfs has {stored}",
                advice=f"write {right}" if right else "write four lower-case hexadecimal digits",
                fix=fix(f"write {right}", (where, right)) if right else None,
            )
        at += len(number) + 1
