"""What the host says of devices, kernel parameters and the other daemons."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.facts.host.packages import near_packages
    from bringup_lint.facts.host.packages import packages
    from bringup_lint.facts.host.programs import is_program
    from bringup_lint.facts.host.programs import meant_programs
    from bringup_lint.facts.host.programs import verbs
    from bringup_lint.facts.host.removed_packages import removed_package
    from bringup_lint.graph.host.device_addresses import own_addresses
    from bringup_lint.graph.host.device_uses import DeviceUse
    from bringup_lint.graph.host.device_uses import device_path
    from bringup_lint.graph.host.dhcp import LostRange
    from bringup_lint.graph.host.dhcp import lost_ranges
    from bringup_lint.graph.host.options import option_of
    from bringup_lint.graph.host.serial_consoles import taken_consoles
    from bringup_lint.graph.host.ungiven_devices import Ungiven
    from bringup_lint.graph.host.ungiven_devices import ungiven_devices
    from bringup_lint.model.fstab import Mount
    from bringup_lint.parsers.sysctl import KernelParameter
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "DeviceUse",
    "KernelParameter",
    "LostRange",
    "Mount",
    "Ungiven",
    "device_path",
    "is_program",
    "lost_ranges",
    "meant_programs",
    "near_packages",
    "option_of",
    "own_addresses",
    "packages",
    "removed_package",
    "taken_consoles",
    "ungiven_devices",
    "verbs",
]
