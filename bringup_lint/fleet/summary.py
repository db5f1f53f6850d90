"""The summary of a robot: all that the rules of the fleet may see of it. It holds no secret, and is data: it goes
through JSON unchanged.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from bringup_lint.dataclass import dataclass
from bringup_lint.named_tuple import NamedTuple

VERSION = 3
"""Of the form of a summary; a stored summary of another version is made anew."""


class Mark(NamedTuple):
    """A keyed hash of key material: two are equal when the material is, and say nothing else."""

    kind: str
    """``ssh-host-key``, ``machine-id``, ``sros2-key``, ``sros2-ca``, ``tls-key``, ``password``, ``access-point``,
    ``vpn-key``, ``wifi-login``."""
    name: str
    """What it belongs to, for people: ``ed25519``, ``user robot``."""
    digest: str
    path: str
    line: int


class Fact(NamedTuple):
    """One thing that the files of a robot say."""

    subject: str
    """``host-name``, ``address``, ``mac``, ``domain``, ``middleware``, ``security``, ``discovery``, ``dds``,
    ``dds-setting``, ``time-source``, ``node``, ``tunnel``, ``certificate``, ``unit``, ``setting``, ``version``,
    ``kernel-parameter``, ``parameter``."""
    key: str
    """What it is about, such as ``rover.service Restart``; empty where the subject says it all."""
    value: str
    path: str
    line: int


class Own(NamedTuple):
    """A finding on one robot by itself, as a run on this robot alone reports it."""

    rule: str
    severity: str
    message: str
    path: str
    line: int
    column: int
    fingerprint: str


@dataclass(frozen=True)
class Summary:
    name: str
    role: str
    """Robots of one role should be alike; ``robot`` when nothing says it."""
    site: str = ""
    """Robots of one site reach each other over the network; all are of one site when nothing says it."""
    domain: int | None = None
    """The DDS domain that the inventory expects."""
    talks: str = ""
    """How the site wants its domains: ``shared``, ``separate``, or empty when nothing says it."""
    path: str = ""
    """What was read, as the user knows it."""
    files: int = 0
    marks: tuple[Mark, ...] = ()
    facts: tuple[Fact, ...] = ()
    own: tuple[Own, ...] = ()
    silenced: tuple[tuple[str, int], ...] = ()
    """What suppresses findings on the robot by itself, and how many; these are not in ``own``."""
    failures: tuple[str, ...] = ()
    """What failed inside, or why the robot could not be read."""
    version: int = VERSION


def to_data(summary: Summary) -> dict[str, Any]:
    return asdict(summary)


def from_data(data: Mapping[str, Any]) -> Summary:
    """Raises ValueError for data of another version, or none at all."""
    try:
        if data["version"] != VERSION:
            raise ValueError("a summary of another version")
        lists = {
            "marks": tuple(Mark(*row) for row in data["marks"]),
            "facts": tuple(Fact(*row) for row in data["facts"]),
            "own": tuple(Own(*row) for row in data["own"]),
            "silenced": tuple((str(what), int(count)) for what, count in data["silenced"]),
            "failures": tuple(data["failures"]),
        }
        return Summary(**{**data, **lists})
    except (KeyError, TypeError) as error:
        raise ValueError("not a summary") from error
