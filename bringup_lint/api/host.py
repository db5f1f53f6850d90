"""What the host says of devices, kernel parameters and the other daemons."""

from __future__ import annotations

from bringup_lint.graph.host.device_uses import DeviceUse
from bringup_lint.model.fstab import Mount
from bringup_lint.parsers.sysctl import KernelParameter

__all__ = [
    "DeviceUse",
    "KernelParameter",
    "Mount",
]
