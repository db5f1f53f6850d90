"""The blocks of Navigation2 in a parameter file, and what is found wrong with one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter


class NavigationProblem(NamedTuple):
    kind: str
    """``footprint``, ``corner``, ``inflation``, ``ranges``, ``source``, ``sign``, ``length``, ``particles``, ``pose``,
    ``model``, ``frame``, ``polygon``, ``library``, ``section``, ``halves``, ``critic``, ``type``, ``clearing``,
    ``turn``, ``slower``, ``tree``, ``old-tree``, ``zone``, ``radii``, ``blind``, ``step``, ``beside``, ``base``,
    ``stray``, ``reversing`` or ``unlisted``."""
    where: Span
    name: str
    """The parameter or observation source."""
    detail: str
    other: Span | None = None
    """What the value contradicts."""


def by_name(block: Block) -> dict[str, Parameter]:
    return {str(each.name): each for each in block.parameters}


def number_of(parameter: Parameter) -> float | None:
    value = parameter.value.data
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else None


def numbers_of(parameter: Parameter | None) -> list[float]:
    """The numbers of a list; empty when it holds anything else."""
    value = parameter.value.data if parameter is not None else None
    found = value if isinstance(value, list) else []
    return found if all(isinstance(each, (int, float)) and not isinstance(each, bool) for each in found) else []
