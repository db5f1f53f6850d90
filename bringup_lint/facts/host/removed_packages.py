"""Packages of apt that Ubuntu dropped (table ``host/removed_packages``)."""

from __future__ import annotations

from functools import lru_cache

from bringup_lint.facts import rows

_RELEASES = {"bionic": "18.04", "focal": "20.04", "jammy": "22.04", "noble": "24.04", "resolute": "26.04"}
_OLDEST = "jammy"
"""The oldest release that Ubuntu still supports for everybody."""


@lru_cache
def _removed() -> dict[str, tuple[str, str]]:
    return {name: (since, instead) for name, since, instead in rows("host/removed_packages")[1]}


def removed_package(name: str, codename: str) -> tuple[str, str] | None:
    """From which release on Ubuntu lacks a package, and what to install instead, where a release lacks it; of an
    unknown one where all that are supported do."""
    since, instead = _removed().get(name, ("", ""))
    asked = _RELEASES.get(codename, _RELEASES[_OLDEST])
    return (_RELEASES[since], instead) if since and asked >= _RELEASES[since] else None
