"""Compose files: services and what they share."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.graph.containers.questions.compose_names import MissingFile
    from bringup_lint.graph.containers.questions.compose_names import defined_names
    from bringup_lint.graph.containers.questions.compose_names import missing_files
    from bringup_lint.graph.containers.questions.compose_names import nearly_named
    from bringup_lint.graph.containers.questions.compose_names import undefined_names
    from bringup_lint.graph.containers.questions.container_names import shared_names
    from bringup_lint.graph.containers.questions.device_groups import closed_devices
    from bringup_lint.graph.containers.questions.health import unchecked_health
    from bringup_lint.graph.containers.questions.image_use import is_workplace
    from bringup_lint.graph.containers.questions.ports import taken_ports
    from bringup_lint.graph.containers.questions.static_addresses import RefusedAddress
    from bringup_lint.graph.containers.questions.static_addresses import refused_addresses
    from bringup_lint.graph.runners.questions.hidden_workspaces import HiddenWorkspace
    from bringup_lint.graph.runners.questions.hidden_workspaces import hidden_workspaces
    from bringup_lint.graph.runners.questions.listening import unserved_ports
    from bringup_lint.model.compose import Beside
    from bringup_lint.model.compose import Device
    from bringup_lint.model.compose import Service
    from bringup_lint.model.compose import Volume
    from bringup_lint.model.compose import reach
    from bringup_lint.parsers.compose_schema import homes_of
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Beside",
    "Device",
    "HiddenWorkspace",
    "MissingFile",
    "RefusedAddress",
    "Service",
    "Volume",
    "closed_devices",
    "defined_names",
    "hidden_workspaces",
    "homes_of",
    "is_workplace",
    "missing_files",
    "nearly_named",
    "reach",
    "refused_addresses",
    "shared_names",
    "taken_ports",
    "unchecked_health",
    "undefined_names",
    "unserved_ports",
]
