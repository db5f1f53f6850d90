"""Values of arguments that ask for what happens without them, so that nothing is lost where nobody takes them."""

from __future__ import annotations

import re
from collections.abc import Collection
from collections.abc import Iterable
from typing import TYPE_CHECKING

from bringup_lint.graph.launch.resolve import text_of
from bringup_lint.model.launch_values import literal
from bringup_lint.pattern import regex

if TYPE_CHECKING:
    from bringup_lint.graph.files import Files
    from bringup_lint.graph.launch.expansion import Expansion
    from bringup_lint.model.launch_values import Value

CLOCK = "use_sim_time"
_OFF = ("false", "0")
_NONE = {"none"}
_SWITCH = "use_"
_WORD = regex(r"[a-z]{4,}")
_GENERAL = frozenset("enable enabled launch node nodes publish run show start with".split())
"""Words of a switch that do not say for what it is."""


def is_real_clock(name: str, text: str | None) -> bool:
    """Whether an argument asks for the clock that every node has when nothing gives it another."""
    return name == CLOCK and (text or "").lower() in _OFF


def is_empty(text: str | None) -> bool:
    """Whether the shell, xacro or launch gets no text at all, as with ``prefix:=""``."""
    return text is not None and not text.strip(" \"'")


def passed_without_effect(arguments: Iterable[tuple[Value, Value]], target: Expansion) -> Collection[str]:
    """The names of the literal arguments of an include that change nothing, whether the target takes them or not: an
    empty text, the real clock where nothing of the target speaks of it, and ``use_X`` off beside an empty ``X``."""
    texts = {str(literal(name)): text_of(value) for name, value in arguments}
    speaks = any(CLOCK in file.source.text for file in target.files)
    return [name for name, text in texts.items() if _changes_nothing(name, text, texts, speaks)]


def _changes_nothing(name: str, text: str | None, texts: dict[str, str | None], speaks_of_clock: bool) -> bool:
    if is_empty(text):
        return True
    if is_real_clock(name, text):
        return not speaks_of_clock
    return name.startswith(_SWITCH) and (text or "").lower() in _OFF and is_empty(texts.get(name[len(_SWITCH) :]))


def happens_anyway(name: str, value: Value, target: Expansion, files: Files) -> bool:
    """Whether an argument that nothing takes asks for what the target does without it: it switches off what no file of
    the target speaks of, it is the default of the argument of which the name is the end, or it is what all parameter
    files of the tree give to a parameter of this name."""
    text = (text_of(value) or "").lower()
    if text in _OFF:
        said = " ".join(file.source.text.lower() for file in target.files)
        return any(word not in said for word in set(_WORD.findall(name.lower())) - _GENERAL)
    if any(each.name.endswith(f"_{name}") and _is_same(each.action.default, value) for each in target.declared):
        return True
    given = regex(rf"(?m)^[ \t]*{re.escape(name)}:[ \t]*[\"']?([^\s\"'#]+)") if text else None
    found = {word.lower() for each in files.of_kind("params") if given for word in given.findall(each.text)}
    return found == {text}


def _is_same(default: Value | None, value: Value) -> bool:
    """Whether two values are written alike, or both say that there is none."""
    if default is None:
        return False
    return default.span.text == value.span.text or {(text_of(each) or "").lower() for each in (default, value)} == _NONE
