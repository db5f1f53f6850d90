"""One robot, checked, as a summary."""

from __future__ import annotations

import traceback
from collections.abc import Callable
from collections.abc import Iterable
from collections.abc import Iterator
from collections.abc import Mapping

from bringup_lint.fleet.reduce import dds
from bringup_lint.fleet.reduce import host
from bringup_lint.fleet.reduce import identity
from bringup_lint.fleet.reduce import ros
from bringup_lint.fleet.reduce.statements import Statements
from bringup_lint.robot import Robot

IDENTITY: tuple[Callable[[Statements], None], ...] = (
    identity.host,
    identity.ssh,
    identity.private_keys,
    identity.passwords,
    identity.networks,
)
READERS = (
    *IDENTITY,
    host.units,
    host.kernel,
    host.versions,
    host.time_sources,
    host.addresses,
    host.certificates,
    host.tunnels,
    ros.domain,
    ros.variables,
    dds.discovery,
    ros.nodes,
    ros.parameters,
)


def reduced(robot: Robot, key: bytes) -> tuple[Statements, list[str]]:
    """What a robot says, and what failed inside on the way. ``key`` is that of the run, for the keyed hashes."""
    return _read_by(READERS, Statements(robot, key))


def identified(robot: Robot, key: bytes, delivered: Mapping[str, str]) -> tuple[Statements, list[str]]:
    """The same, of what makes a robot itself alone, in what Ansible copies to it: place -> file."""
    return _read_by(IDENTITY, Statements(robot, key, delivered))


def _read_by(readers: Iterable[Callable[[Statements], None]], said: Statements) -> tuple[Statements, list[str]]:
    return said, [failure for reader in readers for failure in _failures(reader, said)]


def _failures(reader: Callable[[Statements], None], said: Statements) -> Iterator[str]:
    try:
        reader(said)
    except Exception as error:
        frame = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{frame.filename.rpartition('/')[2]}:{frame.lineno}"
        yield f"summary of {reader.__module__.rpartition('.')[2]} {reader.__name__}: {type(error).__name__} in {where}"
