"""The layers of a robot's bring-up, and the one that each kind of node and edge belongs to."""

from __future__ import annotations

from bringup_lint.graph.graph import Edge
from bringup_lint.graph.graph import Node

LAYERS = {
    "boot": "Boot order",
    "environment": "Environment",
    "launch": "Launch files and nodes",
    "parameters": "Parameters",
    "dds": "DDS",
    "security": "Security",
    "network": "Network",
    "devices": "Devices",
    "topics": "Topics",
}
"""In the order in which a robot comes up, with their titles."""

_OF_NODE = {
    "unit": "boot",
    "user-unit": "boot",
    "user": "boot",
    "compose-service": "boot",
    "program": "boot",
    "script": "boot",
    "env-file": "environment",
    "launch-file": "launch",
    "ros-node": "launch",
    "process": "launch",
    "parameter-file": "parameters",
    "dds-file": "dds",
    "keystore": "security",
    "enclave": "security",
    "permissions-file": "security",
    "governance-file": "security",
    "interface": "network",
    "netplan-file": "network",
    "networkmanager-profile": "network",
    "device": "devices",
    "udev-rule": "devices",
    "topic": "topics",
}
_OF_EDGE = {"opens": "devices", "loads-params": "parameters", "loads-env": "environment"}


def layer_of_node(node: Node) -> str:
    return _OF_NODE[node.kind]


def layer_of_edge(edge: Edge) -> str:
    """That of its target: what an edge leads to is what it is about."""
    return _OF_EDGE.get(edge.kind) or layer_of_node(edge.target)
