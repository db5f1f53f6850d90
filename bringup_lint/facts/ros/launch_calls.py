"""What the constructors of launch and launch_ros take."""

from __future__ import annotations

from functools import cache

from bringup_lint.facts import table
from bringup_lint.named_tuple import NamedTuple

_BASES = {
    "Action": ("condition",),
    "OnActionEventBase": ("action_matcher", "on_event", "target_event_cls", "target_action_cls"),
    "EventHandler": ("matcher", "entities"),
    "BaseEventHandler": ("matcher", "handle_once"),
}
"""Keywords of the classes that are only bases of others."""
_ABOVE = {"OnActionEventBase": "BaseEventHandler", "EventHandler": "BaseEventHandler"}
_AMBIGUOUS = frozenset(("Parameter",))
"""Names of two classes."""
_RELEASED = ("launch.", "launch_ros.")
"""Modules whose constructors the table of the API holds for every distribution."""


class Signature(NamedTuple):
    positional: tuple[str, ...]
    keywords: frozenset[str]
    """All that some distribution takes, those of the base classes included."""
    required: tuple[str, ...]
    lineage: tuple[str, ...]
    """The class and those that its keywords go on to."""


@cache
def signature(name: str) -> Signature | None:
    """Of a class by its full name; None when it is not known in full."""
    module, _, last = name.rpartition(".")
    rows = _rows()
    if last not in rows or last in _AMBIGUOUS or "events" in module.split(".") or not name.startswith(_RELEASED):
        return None
    positional = _listed(rows[last]["positional_order"])
    if any(each.startswith("*") for each in positional):
        return None
    lineage = tuple(_lineage(last))
    keywords = frozenset(word for each in lineage for word in _keywords(each))
    return Signature(positional, keywords, _listed(rows[last]["required"]), lineage)


def needs(known: Signature) -> dict[str, str]:
    """Parameter -> what it must be, where others are refused."""
    found: dict[str, str] = {}
    for each in known.lineage:
        for parameter, what in _types().get(each, {}).items():
            found.setdefault(parameter, what)
    return found


@cache
def _rows() -> dict[str, dict[str, str]]:
    rows = (row for row in table("ros/launch_api") if row["import_from"].startswith(("launch", "launch_ros")))
    return {row["name"]: row for row in rows if "events" not in row["import_from"] and row["kind"] != "function"}


@cache
def _types() -> dict[str, dict[str, str]]:
    found: dict[str, dict[str, str]] = {}
    for row in table("ros/launch_types"):
        found.setdefault(row["class"], {})[row["parameter"]] = row["needs"]
    return found


def _lineage(name: str) -> list[str]:
    found: list[str] = []
    while name and name not in found:
        found.append(name)
        name = _rows()[name]["extra_kwargs_from"] if name in _rows() else _ABOVE.get(name, "")
    return found


def _keywords(name: str) -> list[str]:
    if name in _BASES:
        return list(_BASES[name])
    row = _rows()[name]
    changed = [change.partition(":")[0].lstrip("-") for change in _listed(row["param_changes"])]
    return [*_listed(row["positional_order"]), *_listed(row["keyword_only"]), *changed]


def _listed(text: str) -> tuple[str, ...]:
    return tuple(text.split(",")) if text else ()


def parameters_of(name: str) -> list[str]:
    """All that a class takes, by its name without its module."""
    return sorted({word for each in _lineage(name) for word in _keywords(each)})
