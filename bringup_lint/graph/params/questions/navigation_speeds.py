"""Limits and rates of Navigation2 that do not go together: a velocity smoother that takes away what a controller of the
same file plans with, and steps of MPPI that are shorter than those of its server."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.graph.params.questions.navigation_blocks import NavigationProblem
from bringup_lint.graph.params.questions.navigation_blocks import by_name
from bringup_lint.graph.params.questions.navigation_blocks import number_of
from bringup_lint.graph.params.questions.navigation_blocks import numbers_of
from bringup_lint.graph.params.values import items

if TYPE_CHECKING:
    from bringup_lint.model.params import Block
    from bringup_lint.model.params import Parameter
    from bringup_lint.model.params import ParameterFile

_LINEAR = ("max_vel_x", "vx_max", "desired_linear_vel", "max_linear_vel", "v_linear_max")
_ANGULAR = ("max_vel_theta", "wz_max", "v_angular_max")
_BACKWARDS = ("min_vel_x", "vx_min")
"""What controllers call their limits (dwb_plugins, kinematic_parameters.cpp; nav2_mppi_controller, optimizer.cpp;
nav2_regulated_pure_pursuit_controller and nav2_graceful_controller, parameter_handler.cpp)."""
_LIMITS = (("max_velocity", 0, _LINEAR), ("max_velocity", -1, _ANGULAR), ("min_velocity", 0, _BACKWARDS))
"""A limit of the smoother, the number for the axis, and what it cuts off."""
_MPPI = "nav2_mppi_controller::MPPIController"
_FREQUENCY, _STEP = 20.0, 0.05
"""The defaults of ``controller_frequency`` (controller_server.cpp) and ``model_dt`` (optimizer.cpp)."""
_ROUNDING = 1e-5
_TOLERANCE = 0.02
"""The part of a limit by which rounded values may differ."""


def slower_smoother(file: ParameterFile, smoother: Block) -> Iterator[NavigationProblem]:
    """Limits below those of a controller in the same namespace, each with the first that it cuts off."""
    named = by_name(smoother)
    planned = [
        each
        for block in file.blocks
        if block.node_name == "controller_server" and _namespace(block) == _namespace(smoother)
        for each in _planned(by_name(block))
    ]
    cuts: dict[str, tuple[str, Parameter]] = {}
    for limit, axis, names in _LIMITS:
        allowed = numbers_of(named.get(limit))
        wanted = [each for each in planned if allowed and str(each.name).rpartition(".")[2] in names]
        over = [each for each in wanted if _is_cut(number_of(each), allowed[axis], limit)]
        if over:
            turn = " of theta" if axis else ""
            cuts.setdefault(limit, (f"{limit}{turn} {allowed[axis]:g} instead of {over[0].text}", over[0]))
    if cuts:
        first, (_, other) = next(iter(cuts.items()))
        detail = ", ".join(detail for detail, _ in cuts.values())
        yield NavigationProblem("slower", named[first].span, first, detail, other.span)


def short_steps(server: Block) -> Iterator[NavigationProblem]:
    """The first controller of MPPI whose step is below the period of the server (optimizer.cpp, ``setOffset``)."""
    named = by_name(server)
    given = named.get("controller_frequency")
    frequency = number_of(given) if given is not None else _FREQUENCY
    for each in _planned(named):
        section, _, last = str(each.name).rpartition(".")
        if last not in ("plugin", "primary_controller") or each.value.data != _MPPI or not frequency or frequency < 0:
            continue
        step = named.get(f"{section}.model_dt")
        length = number_of(step) if step is not None else _STEP
        where = given or step
        if length is not None and where is not None and 1 / frequency > length + _ROUNDING:
            other = step.span if step is not None and where is given else None
            yield NavigationProblem("step", where.span, section, f"{length:g} s, {1 / frequency:g} s", other)
            return


def _namespace(block: Block) -> str:
    return block.name.strip("/").rpartition("/")[0]


def _is_cut(wanted: float | None, allowed: float, limit: str) -> bool:
    if wanted is None:
        return False
    if limit == "max_velocity":
        return 0 < allowed * (1 + _TOLERANCE) < wanted
    return 0 >= allowed * (1 + _TOLERANCE) > wanted


def _planned(named: dict[str, Parameter]) -> list[Parameter]:
    """The parameters of the controllers that the server loads."""
    listed = named.get("controller_plugins")
    loaded = [item.text for item in items(listed)] if listed is not None else ["FollowPath"]
    return [each for name, each in named.items() if name.partition(".")[0] in loaded]
