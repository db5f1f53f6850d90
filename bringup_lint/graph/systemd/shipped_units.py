"""The units that Ubuntu and Debian ship, for trees that do not hold them (table ``systemd/units``)."""

from __future__ import annotations

from functools import lru_cache

from bringup_lint.pattern import regex

GENERATED = regex(
    r"\.(?:device|mount|automount|swap|slice|scope)$|^(?:getty|serial-getty|user|user-runtime-dir|modprobe|systemd-fsck"
    r"|systemd-backlight|systemd-growfs|systemd-cryptsetup|systemd-pcrphase|wpa_supplicant|dhcpcd|ifup|netplan-\w+"
    r"|container-getty|autovt|systemd-[\w-]+)@|^(?:dbus-.*|netplan-.*|snap[.-].*|cloud-.*|nvargus-.*|nvidia-.*)\.\w+$",
    hints=".device mount .swap .slice .scope @ dbus- netplan- snap cloud- nvargus- nvidia-",
)
"""Names that the kernel, a generator or an installed package provides, so that nothing in a tree can prove
them missing."""


@lru_cache
def names() -> frozenset[str]:
    return frozenset(unit for unit, *_ in _units())


@lru_cache
def aliases() -> dict[str, str]:
    """Other names of units, such as ``default.target``."""
    return {unit: alias_of for unit, _, _, alias_of, _, _ in _units() if alias_of not in ("", "masked")}


def _units() -> list[tuple[str, ...]]:
    from bringup_lint.facts import rows

    return rows("systemd/units")[1]


def is_shipped(name: str) -> bool:
    """Whether Ubuntu or Debian ships the unit, templates' instances included."""
    if name in names():
        return True
    stem, _, suffix = name.rpartition(".")
    return "@" in stem and f"{stem.partition('@')[0]}@.{suffix}" in names()


def service_type(name: str) -> str:
    """The Type= of a service of Ubuntu or Debian that starts something; empty where they do not ship it."""
    stem, _, suffix = name.rpartition(".")
    template = f"{stem.partition('@')[0]}@.{suffix}"
    return _service_types().get(name) or (_service_types().get(template, "") if "@" in stem else "")


@lru_cache
def _service_types() -> dict[str, str]:
    return {unit: kind for unit, _, _, alias_of, kind, _ in _units() if not alias_of}


@lru_cache
def without_default_dependencies() -> frozenset[str]:
    """The units of the distribution that say DefaultDependencies=no."""
    return frozenset(unit for unit, _, _, _, _, defaults in _units() if defaults == "no")
