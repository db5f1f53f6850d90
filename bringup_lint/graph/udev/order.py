"""What packaged rules files set, and so which own files come too early."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from bringup_lint import facts
from bringup_lint.graph.udev.patterns import matches
from bringup_lint.graph.udev.rule import UdevRule
from bringup_lint.model.udev import Token
from bringup_lint.named_tuple import NamedTuple


class TooEarly(NamedTuple):
    """A token whose file sorts before the packaged file that it depends on, or that overrules it."""

    token: Token
    file: str
    value: str
    """What the packaged file sets instead; empty when it provides what the token asks for."""


@cache
def packaged_files() -> dict[str, str]:
    """Rules files of the distribution with their packages."""
    return {row["file"]: row["package"] for row in facts.table("udev/packaged_files")}


def properties_not_set_yet(rule: UdevRule) -> Iterator[TooEarly]:
    """ENV matches on a property that a later file imports first."""
    for token in rule.line.matches("ENV"):
        wants_value = bool(token.value) == (token.operator == "==")
        file = _first(rule, "property", str(token.attribute))
        if wants_value and file is not None:
            yield TooEarly(token, file["file"], "")


def assignments_overruled(rule: UdevRule) -> Iterator[TooEarly]:
    """GROUP and MODE that a later file assigns anew; := is final."""
    for key in ("GROUP", "MODE"):
        for token in rule.line.assignments(key):
            file = _first(rule, "assignment", key)
            if file is not None and token.operator != ":=" and not _is_same(key, token.value, file["value"]):
                yield TooEarly(token, file["file"], file["value"])


def _is_same(key: str, one: str, other: str) -> bool:
    """Whether two values mean the same: ``664`` and ``0664`` are one mode."""
    if key == "MODE":
        return one.lstrip("0") == other.lstrip("0")
    return one == other


def _first(rule: UdevRule, kind: str, name: str) -> dict[str, str] | None:
    file = rule.source.basename
    for row in _rows(kind):
        if file < row["file"] and _is_for(rule, row["subsystem"]) and matches(row["name"], name):
            return row
    return None


@cache
def _rows(kind: str) -> list[dict[str, str]]:
    return [row for row in facts.table("udev/order") if row["kind"] == kind]


def _is_for(rule: UdevRule, subsystem: str) -> bool:
    return rule.is_for(subsystem) or (subsystem == "usb" and rule.is_for_usb_nodes)
