"""YAML documents and their edits."""

from __future__ import annotations

from bringup_lint.graph.yaml_edits import first_key
from bringup_lint.model.yaml_node import Mapping
from bringup_lint.model.yaml_node import Node
from bringup_lint.model.yaml_node import Scalar
from bringup_lint.model.yaml_node import Sequence
from bringup_lint.model.yaml_node import YamlCode

__all__ = [
    "Mapping",
    "Node",
    "Scalar",
    "Sequence",
    "YamlCode",
    "first_key",
]
