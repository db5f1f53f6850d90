"""Values out of a fixed set of words."""

from __future__ import annotations

from collections.abc import Iterable
from collections.abc import Iterator
from functools import cache

from bringup_lint import facts
from bringup_lint.parsers.systemd_values.numbers import parse_bool
from bringup_lint.parsers.systemd_values.problems import LINE
from bringup_lint.parsers.systemd_values.problems import ValueProblem
from bringup_lint.source import Located
from bringup_lint.spelling import nearest

BOOLEAN = "<bool>"
_ANY_CASE = ("socket-protocol",)


@cache
def enumerations() -> dict[str, dict[str, int]]:
    """Name to word to the first release that knows it; ``<bool>`` stands for the words of a boolean."""
    found: dict[str, dict[str, int]] = {}
    for name, word, since in facts.rows("systemd/enumerations")[1]:
        found.setdefault(name, {})[word] = int(since)
    return found


def choices(name: str, version: int) -> str:
    """The words as a reader wants to see them: ``no, on-failure or always``."""
    words = [word for word, since in enumerations()[name].items() if since <= version or since <= 250]
    shown = ["yes", "no", *words[1:]] if words[:1] == [BOOLEAN] else words
    return ", ".join(shown[:-1]) + f" or {shown[-1]}" if len(shown) > 1 else "".join(shown)


def closest(word: str, known: Iterable[str]) -> str | None:
    """The one known word that was probably meant: another case, ``_`` for ``-``, or a near miss."""
    names = {name.replace("_", "-"): name for name in known if name != BOOLEAN}
    meant = nearest(word.replace("_", "-"), names)
    return names[meant[0]] if len(meant) == 1 else None


def check_choice(name: str, value: Located, version: int, effect: str = LINE) -> Iterator[ValueProblem]:
    known = enumerations()[name]
    since = known.get(value.lower() if name in _ANY_CASE else value)
    if since is not None:
        if since > version:
            yield ValueProblem("too-new", value, choices(name, version), effect, since=since)
    elif not (BOOLEAN in known and parse_bool(value) is not None):
        meant = closest(value, known)
        same = meant is not None and meant.lower() == value.lower()
        yield ValueProblem("invalid", value, choices(name, version), effect, meant, same)
