"""Parameter files."""

from __future__ import annotations

from bringup_lint.graph.params.matching import unreached
from bringup_lint.graph.params.matching import unused
from bringup_lint.graph.params.time import simulated
from bringup_lint.graph.topics.questions.undeclared import Undeclared
from bringup_lint.graph.topics.questions.undeclared import undeclared
from bringup_lint.model.params import Block
from bringup_lint.model.params import Parameter
from bringup_lint.model.params import ParameterFile

__all__ = [
    "Block",
    "Parameter",
    "ParameterFile",
    "Undeclared",
    "simulated",
    "undeclared",
    "unreached",
    "unused",
]
