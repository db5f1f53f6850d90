"""Which devices the words of udev rules speak of: levels of the device chain, subsystems, kernel names."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache

from bringup_lint import facts
from bringup_lint.graph.udev.patterns import is_plain
from bringup_lint.graph.udev.patterns import matches
from bringup_lint.graph.udev.patterns import may_overlap
from bringup_lint.model.udev import Token
from bringup_lint.pattern import regex

USB_DEVICE = "usb_device"
USB_INTERFACE = "usb_interface"
_WELL_KNOWN = frozenset({USB_DEVICE, USB_INTERFACE, "usb-serial", "tty", "video4linux"})

_LEVEL_OF_NAME = (
    (regex(r"(?:\d+-\d+(?:\.\d+)*|usb\d+)\Z"), frozenset({USB_DEVICE})),
    (regex(r"\d+-\d+(?:\.\d+)*:\d+\.\d+\Z"), frozenset({USB_INTERFACE})),
    (regex(r"[0-9a-f]{4,5}:[0-9a-f]{2}:[0-9a-f]{2}\.[0-7]\Z"), frozenset({"pci"})),
    (regex(r"ttyUSB\d+\Z"), frozenset({"usb-serial", "tty"})),
    (regex(r"ttyACM\d+\Z"), frozenset({"tty"})),
    (regex(r"video\d+\Z"), frozenset({"video4linux"})),
)
_INTERFACE_GLOB = regex(r"(?=[^:]*-)[\d*?\[\]-]+[\d.*?\[\]-]*:\d[\d.*?\[\]]*\Z")
"""The dash between bus and port tells ``1-1*:1.0`` from ``*:0``, which SCSI addresses match too."""


@cache
def _owners() -> dict[tuple[str, str], frozenset[str]]:
    return {(row["key"], row["name"]): frozenset(row["device"].split()) for row in facts.table("udev/owners")}


def levels(token: Token) -> frozenset[str] | None:
    """The devices of a chain on which a parent key with ``==`` can hold; None when that is not known."""
    if token.operator != "==" or token.has_substitution or "i" in token.prefix:
        return None
    if token.key == "ATTRS":
        return _owners().get(("ATTRS", str(token.attribute)))
    found = [_levels_of(token.key, pattern) for pattern in token.alternatives]
    return None if None in found else frozenset().union(*(levels for levels in found if levels))


def can_be_one(one: frozenset[str], other: frozenset[str]) -> bool:
    """Whether one device can be of both sets of levels; ``other`` stands for all but the well known ones."""
    if one & other:
        return True
    return bool(("other" in one and other - _WELL_KNOWN) or ("other" in other and one - _WELL_KNOWN))


def _levels_of(key: str, pattern: str) -> frozenset[str] | None:
    if key == "KERNELS":
        return _levels_of_name(pattern)
    return _owners().get((key, pattern)) if is_plain(pattern) else None


def _levels_of_name(pattern: str) -> frozenset[str] | None:
    if not is_plain(pattern):
        return frozenset({USB_INTERFACE}) if _INTERFACE_GLOB.match(pattern) else None
    return next((levels for form, levels in _LEVEL_OF_NAME if form.match(pattern)), None)


@cache
def _kernel_names() -> dict[str, tuple[str, bool]]:
    return {row["name"]: (row["subsystem"], row["order"] == "yes") for row in facts.table("udev/kernel_names")}


def subsystem_of_name(pattern: str) -> str | None:
    """The subsystem whose devices have names like ``ttyUSB*``; None when unknown."""
    stem = re.split(r"[\d*?\[]", pattern, maxsplit=1)[0]
    found = _kernel_names().get(stem)
    return found[0] if found else None


def is_numbered_by_discovery(name: str) -> bool:
    """Whether a kernel name such as ``ttyUSB0`` depends on the order in which devices were found."""
    stem, number = re.fullmatch(r"(.*?)(\d*)", name, re.DOTALL).groups()  # type: ignore[union-attr]
    found = _kernel_names().get(stem)
    return bool(number and found and found[1])


def is_tagged_by_systemd(subsystem: str, kernels: Iterable[str], systemd: int) -> bool:
    """Whether 99-systemd.rules of that release makes a device unit of such a device, for sure or perhaps."""
    names = tuple(kernels)
    for row in facts.table("systemd/tagged"):
        if row["subsystem"] != subsystem or (row["since"] and systemd < int(row["since"])):
            continue
        tagged = row["kernel"].split("|")
        if any(may_overlap(one, name) for one in tagged for name in names) if names else row["usual"] == "yes":
            return True
    return False


def is_open_by_design(name: str) -> bool:
    """Whether a node such as ``/dev/fuse`` is meant to be writable for everybody."""
    return any(matches(row["name"], name) for row in facts.table("udev/open_nodes"))


def drives_nothing(usb_id: str) -> bool:
    """Whether a USB device by ``vendor:product`` is a debug probe, a programmer or the like, a camera or a game pad."""
    vendor, product = usb_id.split(":")
    return any(matches(pattern, product) for pattern in _harmless().get(vendor, ()))


@cache
def _harmless() -> dict[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for row in (*facts.table("udev/tools"), *facts.table("udev/cameras")):
        found[row["vendor"]] = (*found.get(row["vendor"], ()), row["product"])
    return found


@cache
def usb_ids() -> dict[str, dict[str, str]]:
    """Known USB devices by ``vendor:product`` in lower case."""
    return {row["id"]: row for row in facts.table("udev/usb_serial_ids")}
