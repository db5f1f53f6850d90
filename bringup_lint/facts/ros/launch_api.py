"""Which names launch and launch_ros have, in which distribution."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table
from bringup_lint.facts.ros import distros

MODULES = frozenset(
    "launch.actions launch.substitutions launch.conditions launch.event_handlers launch.descriptions"
    " launch.launch_description_sources launch_ros.actions launch_ros.substitutions launch_ros.descriptions"
    " launch_ros.event_handlers launch_ros.parameter_descriptions".split()
)
"""Modules whose public names the table holds in full."""


@cache
def _rows() -> dict[str, list[tuple[str, str, str]]]:
    rows: dict[str, list[tuple[str, str, str]]] = {}
    for row in table("ros/launch_api"):
        rows.setdefault(row["import_from"], []).append((row["name"], row["since_distro"], row["last_seen"]))
    return rows


@cache
def removed(name: str, distribution: str | None) -> frozenset[str]:
    """The keywords that a class had once and that a distribution no longer has; the newest one when it is not known."""
    order = tuple(distros.every())
    found = set()
    rows = (row for row in table("ros/launch_api") if row["name"] == name)
    for change in (change for row in rows for change in row["param_changes"].split(",")):
        keyword, _, last = change.partition(":after ")
        still = distribution in order and last in order and order.index(distribution) <= order.index(last)
        if keyword.startswith("-") and not still:
            found.add(keyword[1:])
    return frozenset(found)


@cache
def names(module: str, distribution: str | None) -> frozenset[str] | None:
    """The names that can be imported from a module; of every distribution when it is not known which one runs."""
    if module not in MODULES:
        return None
    order = distros.supported()
    at = order.index(distribution) if distribution in order else None
    found = set()
    for name, since, last in _rows().get(module, ()):
        if at is None or order.index(since) <= at <= order.index(last):
            found.add(name)
    return frozenset(found)


def module_of(name: str) -> str | None:
    """The one module of launch, launch_ros or ament_index_python that has a class or function; None when several or
    none do."""
    by_module = ((module, {row[0] for row in rows}) for module, rows in _rows().items() if " " not in module)
    modules = [module for module, names in by_module if name in names]
    return modules[0] if len(modules) == 1 else None
