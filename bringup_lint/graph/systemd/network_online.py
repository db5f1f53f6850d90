"""Who waits for the network at boot, and who only seems to."""

from __future__ import annotations

from collections.abc import Iterator

from bringup_lint.graph.memo import kept
from bringup_lint.graph.systemd.unit import Unit
from bringup_lint.graph.systemd.units import Units
from bringup_lint.model.unit import Assignment
from bringup_lint.named_tuple import NamedTuple
from bringup_lint.pattern import regex
from bringup_lint.source import Located
from bringup_lint.source import Span

WAITER = "systemd-networkd-wait-online.service"
ONLINE = "network-online.target"
_EARLY = ("network.target", "network-pre.target", "NetworkManager.service", "systemd-networkd.service")
"""Units that are up before any interface has an address."""
_WAITS = regex(
    r"wait-online|nm-online|\bping\b|wait[-_ ]?for[-_ ]?(?:the[-_ ])?(?:net|ip\b|interface)"
    r"|\b(?:until|while)\b[^\n]{0,80}\b(?:nmcli|networkctl|hostname -I)\b"
)
"""What a script does that waits for the network itself."""
_SHOWS = regex(r"\bip (?:-\S+ ){0,8}(?:a|addr|route)\b")
_AGAIN = regex(r"\b(?:until|while|for|sleep|timeout|exit)\b")
"""What a script does that asks for addresses until there are some."""
_INSTALLED = regex(r"/lib/[\w-]{1,80}/([\w.-]{1,80}\.(?:ba)?sh)\b")
"""A script of a package where colcon installs it, whose prefix is computed."""
_QUESTIONS = frozenset({"list", "info", "find", "type", "get", "show"})
"""Verbs of ros2 topic, node, service and others, which end by themselves."""


class TooEarly(NamedTuple):
    """A unit that needs the network and waits for something that comes before it."""

    unit: Unit
    line: Assignment
    word: Located
    presumed: bool
    """That it runs ROS is not certain."""
    planned: bool = False
    """It does not run ROS yet."""


def waiting_for_network(units: Units) -> list[tuple[str, Located]]:
    """The units that are ordered after network-online.target, each with the word that says so.

    Empty when a drop-in configures the waiting itself: what is waited for is then known to it alone.
    """
    if any(unit.dropins for unit in units.candidates(WAITER)):
        return []
    return [(unit.name, word) for unit in units.judged for word in unit.words("After") if word == ONLINE]


def too_early(units: Units) -> Iterator[TooEarly]:
    """The units that take part in DDS and that can start before any interface has an address."""
    for unit in (*units.dds, *units.presumed_ros, *units.planned_ros):
        named = next((found for key in ("After", "Wants", "Requires") for found in unit.naming(key, *_EARLY)), None)
        if named is None or unit.manager == "user" or unit.unsure_of("After", "Wants", "Requires"):
            continue
        if units.waits_for(unit, ONLINE) or units.stays_local(unit) or _only_asks(unit, units):
            continue
        if not waits_itself(unit, units):
            yield TooEarly(unit, *named, presumed=unit not in units.dds, planned=unit in units.planned_ros)


def _only_asks(unit: Unit, units: Units) -> bool:
    """Whether all that a unit starts of ROS are questions of ros2, each of which is asked anew: the daemon that answers
    begins again when an interface changes."""
    found = [ros for process in units.started(unit) for _, ros in process.ros]
    return bool(found) and all(ros.kind == "cli" and not _QUESTIONS.isdisjoint(ros.command.words) for ros in found)


def waits_itself(unit: Unit, units: Units) -> bool:
    """Whether a command of the unit waits for the network, or a script whose name it has and that the tree installs."""
    texts = [text for process in units.processes(unit) for text in process.texts]
    if any(map(_waits, texts)):
        return True
    names = {name for text in texts for name in _INSTALLED.findall(text)}
    return bool(names) and not names.isdisjoint(_waiting_scripts(units))


@kept
def _waiting_scripts(units: Units) -> frozenset[str]:
    """The names of the scripts of the tree that wait for the network."""
    return frozenset(each.basename for each in units.files.of_kind("shell-script") if _waits(each.text))


def _waits(text: str) -> bool:
    """Whether a script waits, and does not only show or set an address."""
    return _WAITS.search(text) is not None or (_SHOWS.search(text) is not None and _AGAIN.search(text) is not None)


def edits_to_wait(early: TooEarly, units: Units) -> Iterator[tuple[Located | Span, str]]:
    """The edits by which the unit waits for the network and pulls it in."""
    ordered = list(early.unit.naming("After", early.word))
    replaced = early.word == "network.target"
    missing = [] if replaced and ordered else [f"After={ONLINE}"]
    if replaced:
        yield early.word, ONLINE
    if not units.brings_in(early.unit, ONLINE) and (ordered or not replaced):
        missing.insert(0, f"Wants={ONLINE}")
    if missing:
        yield early.line.end, "".join(f"\n{text}" for text in missing)
