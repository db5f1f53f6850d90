"""The running ROS graph, as it was seen on one domain."""

from __future__ import annotations

from bringup_lint.dataclass import dataclass
from bringup_lint.model.node_source import Qos
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Located
from bringup_lint.source import Problem
from bringup_lint.source import Source


class RunningNode(NamedTuple):
    name: Located
    """Fully qualified. Two nodes may have the same one."""
    enclave: Located | None
    state: Located | None
    """Of a lifecycle node: ``active``, ``inactive``, ...; ``no answer`` when it did not tell."""

    @property
    def bare(self) -> str:
        return self.name.rpartition("/")[2]


class Endpoint(NamedTuple):
    topic: Located
    node: Located
    """Fully qualified."""
    publishes: bool
    type: Located
    """``sensor_msgs/msg/LaserScan``."""
    qos: Qos


class RunningUnit(NamedTuple):
    """What systemd says of a unit, in the words of ``systemctl show``."""

    name: Located
    load: Located | None
    """``loaded``, ``masked``, ``bad-setting``, ``error``."""
    active: Located | None
    """``active``, ``inactive``, ``failed``, ..."""
    result: Located | None
    """Why it failed: ``exit-code``, ``timeout``, ``start-limit-hit``, ..."""
    reload: Located | None
    """There when a file of the unit has changed since systemd has read it."""
    fragment: Located | None
    """The unit file that is loaded."""


class RunningParameter(NamedTuple):
    node: Located
    """Fully qualified."""
    name: Located
    value: Located


@dataclass(frozen=True, eq=False)
class ObservedGraph:
    source: Source
    domain: int
    domain_from: str = ""
    """What told the domain: ``--domain-id``, ``ROS_DOMAIN_ID`` of the shell, ``the files``; empty for the default."""
    rmw: str = ""
    secured: bool = False
    """Whether whoever looked had security switched on."""
    nodes: tuple[RunningNode, ...] = ()
    endpoints: tuple[Endpoint, ...] = ()
    elsewhere: tuple[tuple[int, tuple[RunningNode, ...]], ...] = ()
    """Other domains that were looked at, with the nodes there."""
    problems: tuple[Problem, ...] = ()
    units: tuple[RunningUnit, ...] = ()
    """The units of the tree that systemd knows where somebody looked."""
    parameters: tuple[RunningParameter, ...] = ()
