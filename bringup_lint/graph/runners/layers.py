"""The layers that makers of runners ask, each only where its kind of file is in the tree."""

from __future__ import annotations

from collections.abc import Callable

from bringup_lint.dataclass import dataclass
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.containers.compose import Compose
    from bringup_lint.graph.systemd.units import Units


@dataclass(frozen=True, eq=False)
class Layers:
    units: Callable[[], Units]
    compose: Callable[[], Compose]
