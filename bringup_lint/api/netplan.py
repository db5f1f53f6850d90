"""Netplan: the merged plan and its interfaces, and what its grammar knows about a key."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from bringup_lint.api import finding
from bringup_lint.api import note
from bringup_lint.finding import Finding
from bringup_lint.model.netplan import Netplan
from bringup_lint.model.netplan import PlanCode
from bringup_lint.on_demand import on_demand

if TYPE_CHECKING:
    from bringup_lint.graph.netplan.subnets import Subnets
    from bringup_lint.model.netplan import Address
    from bringup_lint.model.netplan import Interface
    from bringup_lint.model.netplan import Plan
    from bringup_lint.parsers.netplan_schema import home_of
else:
    __getattr__ = on_demand(globals())

__all__ = [
    "Address",
    "Interface",
    "Plan",
    "PlanCode",
    "Subnets",
    "home_of",
    "undefined_names",
]


def undefined_names(netplan: Netplan, code: PlanCode) -> Iterator[Finding]:
    """Names of interfaces that no file defines before they are used."""
    for problem in netplan.problems(code):
        name, later = problem.word, problem.detail
        message, advice = f"interface '{name}' is not defined", "define it, even with dhcp4: false"
        if later:
            message = f"'{name}' is defined only in {later}, which sorts later"
            advice = "rename the files so that it is read first"
        yield finding(
            name,
            f"{message}: netplan generates nothing",
            advice=advice,
            related=[note(place, "defined here") for place in netplan.declarations(name) if place.path == later],
        )
