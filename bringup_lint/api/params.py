"""Parameter files."""

from __future__ import annotations

from bringup_lint.model.params import Block
from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile

__all__ = [
    "Block",
    "Parameter",
    "ParameterFile",
]
