"""Parameters that libraries declare in the nodes that they are handed."""

from __future__ import annotations

from fnmatch import fnmatchcase

from bringup_lint.facts import table

OF_EVERY_NODE = ("use_sim_time", "start_type_description_service", "qos_overrides.*")
"""rclcpp and rclpy declare these themselves (rclcpp, time_source.cpp, node_type_descriptions.cpp, qos_overrides)."""


def hands_parameters(package: str) -> bool:
    """Whether a package that is not in the tree may declare parameters in a node."""
    return not any(fnmatchcase(package, row["package"]) for row in table("ros/parameter_free"))


def is_of_library(parameter: str) -> bool:
    """Whether the client library, or a common library, declares a parameter of this name."""
    patterns = [*OF_EVERY_NODE, *(name for row in table("ros/parameter_free") for name in row["names"].split())]
    return any(fnmatchcase(parameter, pattern) for pattern in patterns)


def declared_by(package: str, executable: str) -> frozenset[str] | None:
    """All that a node of a public package declares; None when the table does not know it."""
    for row in table("ros/node_parameters"):
        if (row["package"], row["executable"]) == (package, executable):
            return frozenset(row["parameters"].split())
    return None
