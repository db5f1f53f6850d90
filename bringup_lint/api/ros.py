"""ROS distributions, and the values of ROS variables."""

from __future__ import annotations

from bringup_lint.on_demand import on_demand
from bringup_lint.type_names import TYPE_CHECKING

if TYPE_CHECKING:
    from bringup_lint.facts.ros.distros import at_least
    from bringup_lint.facts.ros.distros import codename_of
    from bringup_lint.facts.ros.distros import distro_end
    from bringup_lint.facts.ros.distros import distro_names
    from bringup_lint.facts.ros.distros import distros_since
    from bringup_lint.facts.ros.distros import named_distros
    from bringup_lint.facts.ros.distros import ros1
    from bringup_lint.facts.ros.needed import COMMON
    from bringup_lint.facts.ros.needed import instead_of
    from bringup_lint.facts.ros.needed import is_debian_package
    from bringup_lint.facts.ros.needed import unresolved
    from bringup_lint.facts.ros.pip_names import pip_names
    from bringup_lint.facts.ros.simulation import is_simulation
    from bringup_lint.facts.ros.variables import misspelt
    from bringup_lint.facts.ros.variables import variables
    from bringup_lint.graph.dependencies.interfaces import Ungenerated
    from bringup_lint.parsers import json5
    from bringup_lint.parsers import ros_arguments
    from bringup_lint.parsers.ros_values import DISCOVERY_RANGES
    from bringup_lint.parsers.ros_values import EPHEMERAL_DOMAINS
    from bringup_lint.parsers.ros_values import FORMAT_TOKENS
    from bringup_lint.parsers.ros_values import FORMAT_TOKENS_SINCE
    from bringup_lint.parsers.ros_values import LOGGING_SWITCHES
    from bringup_lint.parsers.ros_values import MAX_DOMAIN
    from bringup_lint.parsers.ros_values import RMW_IMPLEMENTATIONS
    from bringup_lint.parsers.ros_values import domain_id
    from bringup_lint.parsers.ros_values import highest_port
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "COMMON",
    "DISCOVERY_RANGES",
    "EPHEMERAL_DOMAINS",
    "FORMAT_TOKENS",
    "FORMAT_TOKENS_SINCE",
    "LOGGING_SWITCHES",
    "MAX_DOMAIN",
    "RMW_IMPLEMENTATIONS",
    "Ungenerated",
    "at_least",
    "codename_of",
    "distro_end",
    "distro_names",
    "distros_since",
    "domain_id",
    "highest_port",
    "instead_of",
    "is_debian_package",
    "is_simulation",
    "json5",
    "misspelt",
    "named_distros",
    "pip_names",
    "ros1",
    "ros_arguments",
    "unresolved",
    "variables",
]
