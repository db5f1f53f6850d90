"""What the service manager itself is told: systemd-system.conf(5) and its drop-ins."""

from __future__ import annotations

from collections.abc import Callable

from bringup_lint.source import Located
from bringup_lint.type_names import TYPE_CHECKING
from bringup_lint.type_names import TypeVar

if TYPE_CHECKING:
    from bringup_lint.graph.systemd.daemons import Daemon

Value = TypeVar("Value")


def manager_setting(
    configurations: list[Daemon], key: str, read: Callable[[str], Value | None]
) -> tuple[Located, Value] | None:
    """The last value of a key of [Manager] that ``read`` accepts. Files of several robots side by side leave
    no order: none counts."""
    if len(configurations) != 1 or not configurations[0].certain:
        return None
    return configurations[0].get(key, read=read)
