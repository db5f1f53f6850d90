"""Covariance matrices that are not symmetric, so that one of their numbers is in the wrong place."""

from __future__ import annotations

from collections.abc import Iterator
from math import isqrt
from typing import TYPE_CHECKING

from bringup_lint.graph.params.questions.navigation_blocks import numbers_of
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.source import Span

if TYPE_CHECKING:
    from bringup_lint.graph.params.params import Params
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_SIZES = (3, 6, 15)
"""Rows of the matrices of sensor_msgs, geometry_msgs and robot_localization."""


class Lopsided(NamedTuple):
    file: ParameterFile
    parameter: Parameter
    where: Span
    """The number that is not the same on the other side."""
    row: int
    column: int
    size: int
    variance: float
    """The number of its row that is on the diagonal."""


def lopsided(params: Params) -> Iterator[Lopsided]:
    for file, parameter in params.parameters:
        if "covariance" not in parameter.name.rpartition(".")[2]:
            continue
        numbers = numbers_of(parameter)
        size = isqrt(len(numbers))
        if size in _SIZES and size * size == len(numbers):
            yield from _of_matrix(params, file, parameter, numbers, size)


def _of_matrix(
    params: Params, file: ParameterFile, parameter: Parameter, numbers: list[float], size: int
) -> Iterator[Lopsided]:
    items = params.items(parameter)
    for at, number in enumerate(numbers):
        row, column = divmod(at, size)
        if number != 0 and number != numbers[column * size + row] and len(items) == len(numbers):
            yield Lopsided(file, parameter, items[at].span, row, column, size, numbers[row * size + row])
            return
