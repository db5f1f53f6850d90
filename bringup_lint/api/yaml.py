"""YAML documents and their edits."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.yaml_edits import first_key
    from bringup_lint.graph.yaml_edits import last_key
    from bringup_lint.model.yaml_node import Mapping
    from bringup_lint.model.yaml_node import Node
    from bringup_lint.model.yaml_node import Scalar
    from bringup_lint.model.yaml_node import Sequence
    from bringup_lint.model.yaml_node import YamlCode
    from bringup_lint.parsers.names_beside import is_free_key
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Mapping",
    "Node",
    "Scalar",
    "Sequence",
    "YamlCode",
    "first_key",
    "is_free_key",
    "last_key",
]
