"""How bad it is that rcl refuses a parameter file: whether something loads it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.graph.params.left_files import is_unnamed
from bringup_lint.graph.purpose import Purpose

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import ParameterFile


def severity_of_refusal(params: Params, file: ParameterFile) -> str | None:
    """The severity of what ends the process that loads a file: a rule's own where a node of the tree loads it with rcl,
    info where the tree starts nodes and nothing of it names the file, else a warning."""
    if params.read_by(file) == "rcl":
        return None
    is_for_tests = params.files.purpose(file.source) in (Purpose.TEST, Purpose.CI, Purpose.ARCHIVE)
    return "info" if is_unnamed(params, file) or is_for_tests else "warning"
