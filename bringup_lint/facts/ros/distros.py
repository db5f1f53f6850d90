"""The ROS 2 distributions: their order, their end, what they are built for and which middleware they package."""

from __future__ import annotations

import re
from functools import cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from datetime import date


class Distro(NamedTuple):
    name: str
    end: str
    """The last day with updates, as in ``2027-05-31``; empty for rolling."""
    codename: str
    """Of the Ubuntu release that it is built for."""
    systemd: int | None
    """The systemd of that release; None for distributions older than the tables."""
    cyclonedds: str
    fastdds: str
    """The series of the packaged libraries; empty when it is not known."""


@cache
def every() -> dict[str, Distro]:
    """Name to distribution, oldest first."""
    return {
        row["name"]: Distro(
            row["name"],
            row["end"],
            row["codename"],
            int(row["systemd"]) if row["systemd"] else None,
            row["cyclonedds"],
            row["fastdds"],
        )
        for row in table("ros/distros")
    }


@cache
def ros1() -> dict[str, str]:
    """The distributions of ROS 1 that robots still install, oldest first, each with its last day (``2025-05-31``)."""
    return {row["name"]: row["end"] for row in table("ros/ros1")}


@cache
def distro_names() -> tuple[str, ...]:
    """All distributions, those of ROS 1 last."""
    return (*every(), *ros1())


def named_distros(text: str) -> set[str]:
    """The distributions whose names are words of a text."""
    return {word.lower() for word in _word().findall(text)}


@cache
def _word() -> re.Pattern[str]:
    return re.compile(rf"(?<![a-z])(?:{'|'.join(distro_names())})(?![a-z])", re.I)


@cache
def supported() -> tuple[str, ...]:
    """The distributions that can be a target, oldest first."""
    return tuple(distro.name for distro in every().values() if distro.systemd is not None)


def named_in(name: str) -> str | None:
    """The distribution that a file is for by its name (``base_foxy.launch.py``); None when it names none or several."""
    words = set(re.split(r"[^a-z]+", name.lower()))
    found = [distro for distro in every() if distro in words]
    return found[0] if len(found) == 1 else None


def distros_since(first: str) -> tuple[str, ...]:
    """``first`` and what is newer, oldest first."""
    return supported()[supported().index(first) :]


def codename_of(distro: str) -> str:
    """The Ubuntu that a distribution has packages for; empty for names of no distribution."""
    found = every().get(distro)
    return found.codename if found is not None else ""


def systemd_of(distro: str) -> int:
    """The systemd of the Ubuntu release that a supported distribution is built for."""
    systemd = every()[distro].systemd
    assert systemd is not None, distro
    return systemd


def at_least(distro: str | None, first: str) -> bool | None:
    """Whether a distribution is ``first`` or newer; None when it is not a supported one."""
    return distro in distros_since(first) if distro in supported() else None


def distro_end(distro: str | None) -> date | None:
    """The last day on which a distribution of ROS 2 or 1 gets updates; None when it has no end or is not known."""
    from datetime import date

    found = every().get(distro or "")
    end = found.end if found is not None else ros1().get(distro or "")
    return date.fromisoformat(end) if end else None
