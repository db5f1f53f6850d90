"""Packages that make ends of topics for the nodes which use them."""

from __future__ import annotations

from bringup_lint.facts.ros.parameters import hands_parameters

_MAKERS = frozenset(
    "behaviortree_cpp behaviortree_cpp_v3 rosbag2_cpp rosbag2_transport depthai lanelet2_extension class_loader".split()
)
"""Those that declare no parameters, and have nodes of their own, or load code that may make topics."""


def may_make_topics(package: str) -> bool:
    """Whether a package that is not in the tree may make ends of topics for a node, other than those of every robot
    (``/tf``, ``/tf_static``, ``/diagnostics``, ``/bond``), and those that a node names itself (image_transport and
    message_filters)."""
    return package in _MAKERS or hands_parameters(package)
